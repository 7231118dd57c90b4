package org.pendant.desktop.session;

import org.pendant.controller.state.ControllerState;
import org.pendant.recording.lines.LineProfiler;
import org.pendant.script.vm.Program;

/** Member runs: what a session knows of the programs of a controller, and of those before it. */
final class MemberRuns implements FrameListener {
  private final ProgramOrigin origin = new ProgramOrigin();
  private final RunClock runClock = new RunClock();
  private final LineProfiler profiler;
  private volatile SwitchedOn on;

  MemberRuns(SwitchedOn on) {
    this.on = on;
    profiler =
        new LineProfiler(
            () -> this.on.journal().newestProgram().map(Program::source),
            () -> this.on.controller().safety());
  }

  /** Another controller takes the place of the one before; no thread may drive either. */
  void follow(SwitchedOn next) {
    origin.goBack(next.controller().state().frame());
    runClock.goBack(next.controller().state());
    profiler.clear();
    on = next;
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
