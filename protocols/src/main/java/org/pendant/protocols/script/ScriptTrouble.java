package org.pendant.protocols.script;

/** Script error: why something that a client sent did not run; primary clients are told. */
public sealed interface ScriptTrouble {

  /**
   * The program cannot be right: nothing of it has run.
   *
   * @param line 1-based, in the text that was sent
   * @param column 1-based
   * @param text the controller's own words where it has some, otherwise ours; bytes, one {@code
   *     char} a byte
   */
  record NotCompiled(int line, int column, String text) implements ScriptTrouble {}

  /**
   * The program is right but may not start now.
   *
   * @param why bytes, one {@code char} a byte
   */
  record NotStarted(String why) implements ScriptTrouble {}

  /** The client may only read: it connected in local control (code C210). */
  record ReadOnly() implements ScriptTrouble {}
}
