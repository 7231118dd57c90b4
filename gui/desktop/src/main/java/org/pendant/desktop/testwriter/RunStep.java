package org.pendant.desktop.testwriter;

import java.util.Optional;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.Question;

/** Run step: something that happened in a run and that a test can repeat, or wants to see again. */
sealed interface RunStep {
  /** In which frame, 0 for the one in which the program started. */
  long frame();

  /** An input or input register was set from outside. */
  record Input(long frame, SignalWrite write) implements RunStep {}

  /** The speed slider was moved, to 0 to 1. */
  record Slider(long frame, double fraction) implements RunStep {}

  /**
   * The program was paused.
   *
   * @param byHand whether somebody outside did it, and not the program itself
   */
  record Pause(long frame, boolean byHand) implements RunStep {}

  /** Somebody had the program continue after {@link Pause}. */
  record Resume(long frame) implements RunStep {}

  /** Somebody stopped the program. */
  record Stop(long frame) implements RunStep {}

  /** The program showed a popup and waits for it to be closed. */
  record PopupShown(long frame, String text) implements RunStep {}

  /**
   * A popup was closed that the program waited for.
   *
   * @param older how many popups are on the screen that came before it
   */
  record PopupClosed(long frame, int older) implements RunStep {}

  /**
   * The program asked the operator something.
   *
   * @param text bytes, one {@code char} a byte
   * @param answer what was said; empty where that is not known, or nothing was
   * @param thoughtFrames how long after the question
   */
  record Asked(
      long frame, String text, Question.Kind kind, Optional<Answer> answer, long thoughtFrames)
      implements RunStep {}

  /** An output has changed by what the program did. */
  record Output(long frame, Signal signal, boolean level) implements RunStep {}
}
