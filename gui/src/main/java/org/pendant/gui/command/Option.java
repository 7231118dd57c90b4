package org.pendant.gui.command;

/**
 * One option of a subcommand.
 *
 * @param name with its two dashes, e.g. {@code --speed}
 * @param value what follows it, as the usage text calls it; empty for a switch
 * @param description one line for the usage text
 */
record Option(String name, String value, String description) {

  /** Whether a value follows the name. */
  boolean takesValue() {
    return !value.isEmpty();
  }

  /** The option as the usage text shows it, e.g. {@code --speed max|1|N}. */
  String usage() {
    return takesValue() ? name + " " + value : name;
  }
}
