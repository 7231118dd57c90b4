package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.Optional;
import org.eclipse.lsp4j.debug.StoppedEventArgumentsReason;

/** Stop wishes: why a program will stop that somebody has asked to. Only the session uses it. */
final class StopWishes {
  /** Why a request has paused a program. */
  enum Pause {
    /** A client asked for it. */
    ASKED("pause", "paused"),
    /** It was to stop before its first statement. */
    ENTRY("entry", "pausedAtEntry"),
    /** One frame of a step is over. */
    FRAME("step", "pausedAfterFrame");

    private final String reason;
    private final String key;

    Pause(String reason, String key) {
      this.reason = reason;
      this.key = key;
    }

    String reason() {
      return reason;
    }

    String description() {
      return text(key);
    }
  }

  /** What a step is to lead to. */
  enum Step {
    /** The next statement, in whatever function. */
    STATEMENT(StoppedEventArgumentsReason.STEP),
    /** A line. */
    LINE(StoppedEventArgumentsReason.GOTO),
    /** Where a move begins, or where the one that is under way has ended. */
    MOVE(StoppedEventArgumentsReason.STEP);

    private final String reason;

    Step(String reason) {
      this.reason = reason;
    }

    String reason() {
      return reason;
    }
  }

  private Optional<Pause> pause = Optional.empty();
  private Step step = Step.STATEMENT;

  /** The next pause on request is for {@code why}. */
  void expect(Pause why) {
    pause = Optional.of(why);
  }

  /** The next step that ends is one to {@code target}. */
  void expect(Step target) {
    step = target;
  }

  /** Why a request has paused the program. */
  Pause takePause() {
    Pause why = pause.orElse(Pause.ASKED);
    pause = Optional.empty();
    return why;
  }

  /** What the step that has ended was to lead to. */
  Step takeStep() {
    Step was = step;
    step = Step.STATEMENT;
    return was;
  }
}
