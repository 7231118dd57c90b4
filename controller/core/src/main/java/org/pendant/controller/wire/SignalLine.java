package org.pendant.controller.wire;

/** Signal line: a signal at work. The frame loop owns it. */
public interface SignalLine {
  /** Its value now; a digital signal is 0 or 1. */
  int value();

  /** Sets it. */
  void set(int value);

  /** Whether it is on: high, or another number than 0. */
  default boolean high() {
    return value() != 0;
  }

  /** Sets a digital signal. */
  default void set(boolean level) {
    set(level ? 1 : 0);
  }
}
