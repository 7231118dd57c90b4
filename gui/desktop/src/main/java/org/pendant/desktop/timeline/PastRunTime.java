package org.pendant.desktop.timeline;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.RunTime;
import org.pendant.recording.Moment;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.script.vm.ProgramState;

/**
 * Past run time: how long the program had run at the moment that people look at. That is known a
 * little later: a recording is gone through elsewhere, once for each run. Only for the dispatch
 * thread.
 */
public final class PastRunTime {
  private final LookBack lookBack;
  private final RecordingReader<Run> reader;
  private Optional<Run> known = Optional.empty();

  /** How often all was forgotten: what was asked for before does not count. */
  private int forgotten;

  /** A run as far as it was gone through. */
  private record Run(RecordedProgram program, long lastFrame, List<Change> changes) {
    boolean covers(RecordedProgram wanted, long frame) {
      return program.equals(wanted) && frame <= lastFrame;
    }

    RunTime at(long frame) {
      return changes.stream()
          .filter(each -> each.frame() <= frame)
          .reduce((earlier, later) -> later)
          .map(Change::time)
          .orElse(RunTime.NONE);
    }
  }

  /** What holds from a frame on. */
  private record Change(long frame, RunTime time) {}

  /** Of the moment of {@code lookBack}. */
  public PastRunTime(LookBack lookBack) {
    this(lookBack, RecordingReader.ofWindow("run-time"));
  }

  PastRunTime(LookBack lookBack, RecordingReader<Run> reader) {
    this.lookBack = lookBack;
    this.reader = reader;
  }

  /** The time of the program that ran then, or ran last; unknown while people look at now. */
  public RunTime time() {
    Optional<Moment> moment = lookBack.moment();
    Recording recording = lookBack.recording();
    Optional<RecordedProgram> ran = moment.flatMap(at -> recording.programOf(at.frame()));
    if (ran.isEmpty() || ran.get().frame() < recording.firstFrame()) {
      return RunTime.NONE;
    }
    long frame = moment.orElseThrow().frame();
    Optional<Run> run = known.filter(each -> each.covers(ran.get(), frame));
    if (run.isEmpty()) {
      int asked = forgotten;
      reader.read(
          () -> read(recording, ran.get()),
          read -> known = Optional.of(read).filter(each -> asked == forgotten),
          why -> known = Optional.empty());
    }
    return run.map(each -> each.at(frame)).orElse(RunTime.NONE);
  }

  /** Another controller has another past, which may begin as that of the one before. */
  public void forget() {
    forgotten++;
    reader.forget();
    known = Optional.empty();
  }

  private static Run read(Recording recording, RecordedProgram program) {
    long last =
        recording.programs().stream()
            .mapToLong(RecordedProgram::frame)
            .filter(frame -> frame > program.frame())
            .map(frame -> frame - 1)
            .findFirst()
            .orElse(recording.lastFrame());
    Follower follower = new Follower(program);
    recording.frames(program.frame(), last, follower::take);
    return new Run(program, last, List.copyOf(follower.changes));
  }

  /** Follows a program from its start on. */
  private static final class Follower {
    private final List<Change> changes = new ArrayList<>();
    private ProgramState before = ProgramState.RUNNING;

    Follower(RecordedProgram program) {
      changes.add(new Change(program.frame(), RunTime.began(program.timeS())));
    }

    void take(ControllerState state) {
      ProgramState now = state.program().state();
      if (now != before) {
        before = now;
        RunTime changed = changes.getLast().time().changed(now, state.timeS());
        changes.add(new Change(state.frame(), changed));
      }
    }
  }
}
