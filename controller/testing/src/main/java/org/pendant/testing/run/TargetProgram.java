package org.pendant.testing.run;

import java.util.List;
import java.util.Optional;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;
import org.pendant.script.vm.ScriptFailure.StackEntry;
import org.pendant.testing.remote.SentText;
import org.pendant.testing.remote.TargetEvent;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetState.RunState;

/**
 * Target program: how the program is that was sent to a target, from what this tells by two
 * connections, of which neither knows how far the other is. An end counts when both have told it,
 * and messages that belong to it had time to come.
 */
final class TargetProgram {
  /** How long after the end of a program messages may come that belong to it, s. */
  private static final double SETTLING_S = 0.1;

  /** A program that has not started by then does not, s. */
  private static final double STARTING_S = 10;

  /** A program of which nothing is told but that nothing runs has ended, s. */
  private static final double SILENT_S = 3;

  private enum Phase {
    NONE,
    SENT,
    RUNNING,
    SETTLING,
    ENDED
  }

  private Phase phase = Phase.NONE;
  private Optional<Sent> sent = Optional.empty();
  private Optional<ScriptFailure> failure = Optional.empty();
  private boolean stopAsked;
  private boolean paused;
  private double nowS;
  private double sinceS;
  private double idleSinceS;

  /**
   * What has been sent.
   *
   * @param source that it was made from
   * @param function the name of its program
   */
  private record Sent(Source source, String function, SentText text) {}

  /**
   * A program has been sent.
   *
   * @param source that it was made from
   * @param function its name
   */
  void sent(Source source, String function, SentText text) {
    sent = Optional.of(new Sent(source, function, text));
    failure = Optional.empty();
    stopAsked = false;
    paused = false;
    to(Phase.SENT);
  }

  /** The test has asked for its end. */
  void stopAsked() {
    stopAsked = true;
  }

  /** Something has happened. */
  void take(TargetEvent event) {
    switch (event) {
      case TargetEvent.Started _ when phase == Phase.SENT -> to(Phase.RUNNING);
      case TargetEvent.Ended _ when phase == Phase.RUNNING -> to(Phase.SETTLING);
      case TargetEvent.Failed failed when phase != Phase.NONE && phase != Phase.ENDED -> {
        failure = Optional.of(failure(failed));
        if (phase == Phase.SENT) {
          // it does not compile, or is refused
          to(Phase.SETTLING);
        }
      }
      default -> {}
    }
  }

  /** A state has come. */
  void see(TargetState state) {
    nowS = state.timeS();
    RunState run = state.runState();
    paused = run == RunState.PAUSED || run == RunState.PAUSING;
    boolean idle = run == RunState.STOPPED;
    if (!idle) {
      idleSinceS = nowS;
    }
    if (phase == Phase.RUNNING && nowS - Math.max(sinceS, idleSinceS) > SILENT_S) {
      to(Phase.SETTLING);
    }
    if (phase == Phase.SETTLING && idle && nowS - sinceS >= SETTLING_S) {
      to(Phase.ENDED);
    }
  }

  private void to(Phase next) {
    phase = next;
    sinceS = nowS;
    idleSinceS = nowS;
  }

  /** Whether it should long have started. */
  boolean overdue() {
    return phase == Phase.SENT && nowS - sinceS > STARTING_S;
  }

  ProgramState state() {
    if (phase == Phase.NONE || phase == Phase.ENDED) {
      return ProgramState.STOPPED;
    }
    return paused ? ProgramState.PAUSED : ProgramState.RUNNING;
  }

  /** How it ended; empty before. */
  Optional<Ending> ending() {
    if (phase != Phase.ENDED) {
      return Optional.empty();
    }
    if (failure.isPresent()) {
      return failure.map(Ending.Failed::new);
    }
    return Optional.of(stopAsked ? new Ending.Stopped() : new Ending.Finished());
  }

  private ScriptFailure failure(TargetEvent.Failed failed) {
    Source file = sent.orElseThrow().source();
    SentText text = sent.orElseThrow().text();
    int line = Math.clamp(text.lineOf(failed.line()), 1, file.lineCount());
    int column = text.columnOf(failed.line(), failed.column());
    String whole = file.lineText(line);
    int blank = whole.length() - whole.stripLeading().length();
    int start = file.lineStart(line) + Math.clamp(column - 1, blank, whole.length());
    return new ScriptFailure(
        "target-error",
        failed.text(),
        new SourceRange(start, file.lineStart(line) + whole.length()),
        line,
        column,
        List.of(new StackEntry(sent.orElseThrow().function(), line)));
  }
}
