package org.pendant.editors.dap.run;

import org.pendant.controller.DebugCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;

/** Hold after frame: a step of one frame. One thread sees the frames, any thread may wish. */
final class HoldAfterFrame {
  private final Robot robot;
  private volatile boolean wanted;
  private long lastStop;

  HoldAfterFrame(Robot robot) {
    this.robot = robot;
  }

  /** Has the program held when the next frame is over. */
  void wish() {
    wanted = true;
  }

  /** After each frame, and while one is held. */
  void see(ControllerState state) {
    long stop = state.debug().stop().map(DebugState.Stop::number).orElse(0L);
    if (wanted && stop == 0) {
      wanted = false;
      var _ = robot.submit(new DebugCommand.Debug(Debugger::pause));
    } else if (stop != lastStop) {
      // something else has held it within the frame
      wanted = false;
    }
    lastStop = stop == 0 ? lastStop : stop;
  }
}
