package org.pendant.editors.dap.run;

import org.pendant.controller.state.ControllerState;

/** Run listener: told of what happens, by the thread that drives the robot. */
public interface RunListener {
  /**
   * A frame has ended, or a debugger holds it, or commands were carried out without one.
   *
   * @throws InterruptedException if the thread is interrupted, as it waits for a slow reader
   */
  void frame(ControllerState state) throws InterruptedException;

  /** Something happened to the program that people should know. */
  void note(String text);

  /**
   * A safety function has stopped the arm and robot time stands still, as {@link
   * DebuggedRobot#stopAtSafetyStops} wants it.
   */
  void safetyStop(ControllerState state);

  /** A robot that others drive has gone on after a safety stop. */
  void wentOn();

  /** The program has ended and the arm rests. */
  void over(RunResult result);

  /** A fault in Pendant: nothing more happens. */
  void failed(Throwable fault);
}
