package org.pendant.controller;

import org.pendant.controller.state.RuntimeState;
import org.pendant.script.vm.ProgramState;

/** Runtime state tracker: derives the runtime state from program and arm, frame by frame. */
final class RuntimeStateTracker {
  private RuntimeState now = RuntimeState.STOPPED;
  private double scalingBefore;

  /**
   * Looks at a frame.
   *
   * @param pausing whether threads only run on until the arm's path to rest is known
   * @param moves whether the arm is told to move
   * @param scaling how fast motion time runs, 0 to 1
   */
  RuntimeState look(ProgramState program, boolean pausing, boolean moves, double scaling) {
    now =
        switch (program) {
          case RUNNING -> pausing ? RuntimeState.PAUSING : running(scaling);
          case PAUSED -> moves ? RuntimeState.PAUSING : RuntimeState.PAUSED;
          case STOPPED ->
              moves && now != RuntimeState.STOPPED ? RuntimeState.STOPPING : RuntimeState.STOPPED;
        };
    scalingBefore = scaling;
    return now;
  }

  private RuntimeState running(double scaling) {
    return switch (now) {
      case PAUSED, PAUSING -> RuntimeState.RESUMING;
      case RESUMING -> scaling > scalingBefore ? RuntimeState.RESUMING : RuntimeState.PLAYING;
      case STOPPED, STOPPING, PLAYING -> RuntimeState.PLAYING;
    };
  }
}
