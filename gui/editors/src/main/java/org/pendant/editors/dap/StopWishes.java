package org.pendant.editors.dap;

import java.util.Optional;

/** Stop wishes: why a program will stop that somebody has asked to. Only the session uses it. */
final class StopWishes {
  /** Why a request has paused a program. */
  enum Pause {
    /** A client asked for it. */
    ASKED("pause", "Paused"),
    /** It was to stop before its first statement. */
    ENTRY("entry", "Paused before the first statement"),
    /** One frame of a step is over. */
    FRAME("step", "Paused after a frame of 2 ms");

    private final String reason;
    private final String description;

    Pause(String reason, String description) {
      this.reason = reason;
      this.description = description;
    }

    String reason() {
      return reason;
    }

    String description() {
      return description;
    }
  }

  private Optional<Pause> pause = Optional.empty();
  private boolean toLine;

  /** The next pause on request is for {@code why}. */
  void expect(Pause why) {
    pause = Optional.of(why);
  }

  /** The next step that ends is a run to a line. */
  void expectLine(boolean wanted) {
    toLine = wanted;
  }

  /** Why a request has paused the program. */
  Pause takePause() {
    Pause why = pause.orElse(Pause.ASKED);
    pause = Optional.empty();
    return why;
  }

  /** Whether the step that has ended was a run to a line. */
  boolean takeLine() {
    boolean was = toLine;
    toLine = false;
    return was;
  }
}
