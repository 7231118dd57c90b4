package org.pendant.desktop.session;

import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramState;

/** Run clock: takes the time of the program that was started last. */
final class RunClock implements FrameListener {
  private volatile RunTime time = RunTime.NONE;

  /** Used by the thread that drives the frames. */
  private ProgramState before = ProgramState.STOPPED;

  @Override
  public void frame(ControllerState state) {
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Started) {
        time = RunTime.began(state.timeS());
        before = ProgramState.RUNNING;
      }
    }
    ProgramState now = state.program().state();
    if (now == before) {
      return;
    }
    before = now;
    time = time.changed(now, state.timeS());
  }

  /**
   * Another controller takes the place of the present one and stands at {@code state}. No thread
   * may drive either.
   */
  void goBack(ControllerState state) {
    before = state.program().state();
    boolean known = time.beganS() <= state.timeS() && time.pausedS(state.timeS()) == 0;
    time = known && before == ProgramState.RUNNING ? RunTime.began(time.beganS()) : RunTime.NONE;
  }

  /** The time of the program that was started last. */
  RunTime time() {
    return time;
  }
}
