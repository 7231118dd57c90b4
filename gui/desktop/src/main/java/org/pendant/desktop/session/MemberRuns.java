package org.pendant.desktop.session;

import java.util.Optional;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.recording.lines.LineProfiler;
import org.pendant.script.vm.Program;

/** Member runs: what a session knows of the programs of a controller, and of those before it. */
final class MemberRuns implements FrameListener {
  private final ProgramOrigin origin = new ProgramOrigin();
  private final RunClock runClock = new RunClock();
  private volatile LineProfiler profiler;
  private volatile SwitchedOn on;

  MemberRuns(SwitchedOn on) {
    this.on = on;
    profiler = new LineProfiler(this::source, this::safety);
  }

  /** Another controller takes the place of the one before; no thread may drive either. */
  void follow(SwitchedOn next) {
    profiler.clear();
    follow(next, profiler);
  }

  /**
   * As {@link #follow(SwitchedOn)}, where the other one repeats a part of the present run.
   *
   * @param lines what the program took in that part, by {@link #linesUntil}
   */
  void follow(SwitchedOn next, LineProfiler lines) {
    origin.goBack(next.controller().state().frame());
    runClock.goBack(next.controller().state());
    profiler = lines;
    on = next;
  }

  /** What the program takes in the part of the present run that another controller repeats. */
  LineProfiler linesUntil(SwitchedOn again) {
    return profiler.until(again.ring().recording(), again.controller().safety());
  }

  private Optional<Source> source() {
    return on.journal().newestProgram().map(Program::source);
  }

  private SafetyConfiguration safety() {
    return on.controller().safety();
  }

  @Override
  public void frame(ControllerState state) {
    origin.frame(state);
    runClock.frame(state);
    profiler.see(state);
  }

  ProgramOrigin origin() {
    return origin;
  }

  RunClock runClock() {
    return runClock;
  }

  LineProfiler profiler() {
    return profiler;
  }
}
