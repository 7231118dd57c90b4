package org.pendant.command;

import java.util.List;

/** Subcommand: one task that {@code pendant} can do, chosen by the first word after it. */
interface Subcommand {

  /** Every subcommand understands this. */
  Option HELP = Option.flag("--help", "show this text");

  /** The word that chooses it. */
  String name();

  /** What follows the options in the usage line, e.g. {@code FILE...}. */
  String operands();

  /** One line for the list of subcommands. */
  String summary();

  /** Its options besides {@link #HELP}. */
  List<Option> options();

  /**
   * Does it.
   *
   * @throws UsageException when the arguments make no sense; the caller explains and exits with 2
   */
  ExitCode run(Arguments arguments, Console console) throws UsageException;

  /**
   * Whether the process may end at once after what {@link #run} did last: nothing is left to be
   * cleared away, and no signal has begun to end it.
   */
  default boolean mayEndAtOnce() {
    return false;
  }
}
