package org.pendant.command;

/**
 * One option of a subcommand.
 *
 * @param name with its two dashes, e.g. {@code --speed}
 * @param value what follows it, as the usage text calls it; empty for a switch
 * @param description one line for the usage text
 * @param role what the command does with the file that the value names
 */
record Option(String name, String value, String description, Role role) {
  /** What a command does with the file that a value names. */
  enum Role {
    /** There is none. */
    NO_FILE,
    /** It is read by {@link SourceFiles}, and thereby safe from being overwritten. */
    READ,
    /** It is written by {@link OutputFile}, which refuses what is read. */
    WRITTEN
  }

  /** One that names no file. */
  Option(String name, String value, String description) {
    this(name, value, description, Role.NO_FILE);
  }

  /** One that names a file to be read. */
  static Option input(String name, String value, String description) {
    return new Option(name, value, description, Role.READ);
  }

  /** One that names a file to be written. */
  static Option output(String name, String value, String description) {
    return new Option(name, value, description, Role.WRITTEN);
  }

  /** Whether a value follows the name. */
  boolean takesValue() {
    return !value.isEmpty();
  }

  /** The option as the usage text shows it, e.g. {@code --speed max|1|N}. */
  String usage() {
    return takesValue() ? name + " " + value : name;
  }
}
