package org.pendant.project.program;

import java.util.List;

/** Action node: does something else than moving, or only structures the tree. */
public sealed interface ActionStep extends Step {

  /** Waits for something. */
  record Wait(WaitFor what) implements ActionStep {}

  /** Sets something. */
  record SetAction(Setting setting) implements ActionStep {}

  /**
   * Shows a message.
   *
   * @param text what it says, or an expression for that
   * @param isExpression whether {@code text} is an expression
   * @param halts whether the program ends after it
   */
  record Popup(String text, boolean isExpression, PopupKind kind, boolean halts)
      implements ActionStep {}

  /** How serious a {@link Popup} is. */
  enum PopupKind {
    MESSAGE,
    WARNING,
    ERROR
  }

  /** Ends the program. */
  record Halt() implements ActionStep {}

  /** A remark for people. */
  record Comment(String text) implements ActionStep {}

  /** Groups its children under a name; they run in order. */
  record Folder(String name) implements ActionStep {}

  /** Gives a variable a value that is computed. */
  record Assignment(String variable, String expression) implements ActionStep {}

  /** Gives a variable a value that the operator is asked for. */
  record OperatorInput(String variable, InputKind kind, String message) implements ActionStep {}

  /** What an operator is asked for. */
  enum InputKind {
    BOOLEAN,
    INTEGER,
    FLOAT,
    TEXT
  }

  /** Calls a {@link Section.SubProgram} by name. */
  record Call(String subProgram) implements ActionStep {}

  /** One line of URScript. */
  record ScriptLine(String code) implements ActionStep {}

  /**
   * The URScript of a file.
   *
   * @param file relative to the program's; empty for none
   * @param lines of the file as it was read last
   */
  record ScriptFile(String file, List<String> lines) implements ActionStep {
    public ScriptFile {
      lines = List.copyOf(lines);
    }
  }

  /**
   * Starts, stops or resets a stop watch, a variable that counts seconds.
   *
   * @param name of the variable
   */
  record Timer(String name, TimerAction action) implements ActionStep {}

  /** What happens to a stop watch. */
  enum TimerAction {
    START,
    STOP,
    RESET
  }
}
