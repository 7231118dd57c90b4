package org.pendant.testing.remote;

/** Target event: what a target tells as it happens. Texts are bytes, one {@code char} a byte. */
public sealed interface TargetEvent {

  /** A program has written a line with {@code textmsg}. */
  record Said(String text) implements TargetEvent {}

  /** The controller has something to say. */
  record Noted(String text) implements TargetEvent {}

  /**
   * A popup is on the screen.
   *
   * @param number by which it is told from others
   */
  record PopupOpened(long number, String text) implements TargetEvent {}

  /** A program asks the operator for a value. */
  record Asked(String text) implements TargetEvent {}

  /** A program has started. */
  record Started() implements TargetEvent {}

  /** A program has ended. */
  record Ended() implements TargetEvent {}

  /**
   * A program fails, or does not compile.
   *
   * @param line of the text that was sent, 1-based
   * @param column 1-based
   */
  record Failed(int line, int column, String text) implements TargetEvent {}
}
