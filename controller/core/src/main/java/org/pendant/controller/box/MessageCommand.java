package org.pendant.controller.box;

import org.pendant.controller.command.Command;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.LogEntry;

/** Command about messages to people and questions to them: popups, questions, the log. */
public sealed interface MessageCommand extends Command {

  /** Closes a popup; a program that it paused continues. */
  record AnswerPopup(long number) implements MessageCommand {}

  /**
   * Answers a question of a program. An answer of another kind is refused, and the question stays
   * open; a whole number answers a question for a number as well.
   */
  record AnswerQuestion(long number, Answer answer) implements MessageCommand {}

  /** Refuses to answer a question: the program stops (manual 18.73). */
  record CancelQuestion(long number) implements MessageCommand {}

  /**
   * Shows a window that holds up nothing, for an operator.
   *
   * @param title bytes, one {@code char} a byte
   * @param text bytes, one {@code char} a byte
   */
  record ShowPopup(String title, String text) implements MessageCommand {}

  /**
   * Writes a line to the log for a client of a protocol.
   *
   * @param text bytes, one {@code char} a byte
   */
  record WriteLog(LogEntry.Level level, String text) implements MessageCommand {}
}
