package org.pendant.command;

import java.util.List;
import org.pendant.text.Texts;

/** Subcommand: one task that {@code pendant} can do, chosen by the first word after it. */
interface Subcommand {

  /** Every subcommand understands this. */
  Option HELP = Option.flag("--help");

  /** The word that chooses it, by which the usage texts explain it. */
  String name();

  /** What follows the options in the usage line, e.g. {@code FILE...}. */
  String operands();

  /** One line for the list of subcommands. */
  default String summary(Texts usage) {
    return usage.get(name());
  }

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
