package org.pendant.protocols.script;

/**
 * Script item: one complete thing that a client has sent. Texts are bytes, one {@code char} a byte.
 */
sealed interface ScriptItem {

  /**
   * From a {@code def} or {@code sec} in the first column to an {@code end} there.
   *
   * @param text with all line ends
   */
  record Program(String text) implements ScriptItem {}

  /**
   * A single line.
   *
   * @param text without its line end, not blank
   */
  record Line(String text) implements ScriptItem {}
}
