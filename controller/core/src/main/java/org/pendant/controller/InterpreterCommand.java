package org.pendant.controller;

import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.script.vm.InterpretedLine;

/** Command to interpreter mode (manual 13). */
public sealed interface InterpreterCommand extends Command {

  /**
   * Hands a line of statements to interpreter mode (manual 13).
   *
   * <p>While a line before it may still clear what was interpreted, it waits for its reply.
   */
  record Interpret(InterpretedLine line) implements InterpreterCommand {
    /**
     * Reads the line.
     *
     * @param line bytes, one {@code char} a byte, without the line end
     */
    public Interpret(String line) {
      this(InterpretedLine.read(line));
    }
  }

  /** Drops the interpreted lines that have not begun (manual 13.6). */
  record SkipInterpreted() implements InterpreterCommand {}

  /** Asks what interpreter mode is at; the answer is a {@link Reply.InterpreterState}. */
  record AskInterpreter() implements InterpreterCommand {}
}
