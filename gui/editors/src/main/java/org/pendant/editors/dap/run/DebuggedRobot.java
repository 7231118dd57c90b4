package org.pendant.editors.dap.run;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Robot;
import org.pendant.recording.Recording;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.ScriptError;

/** Debugged robot: a robot whose programs are debugged, wherever it is driven. Any thread. */
public interface DebuggedRobot extends AutoCloseable {
  /** Asks the debugger something before each frame; it may hold the program. */
  @FunctionalInterface
  interface FrameWatch {
    void look(Debugger debugger);
  }

  /** Something to ask the debugger. */
  @FunctionalInterface
  interface Question<T> {
    /**
     * Asks it.
     *
     * @throws IllegalArgumentException if it cannot be done now
     * @throws ScriptError if an expression fails
     */
    T of(Debugger debugger) throws ScriptError;
  }

  /** The robot, to be read and asked. */
  Robot robot();

  /** What it has done so far. */
  Recording recording();

  /**
   * Asks the debugger; fails with {@link IllegalArgumentException} or {@link ScriptError}. The
   * answer comes by the executor that was given for answers.
   */
  <T> CompletableFuture<T> ask(Question<T> question);

  /** Has {@code watch} asked before each frame from now on; empty for nothing. */
  void watch(Optional<FrameWatch> watch);

  /** Has the program held again after the frame that is under way or comes next. */
  void holdAfterFrame();

  /** Whether people want to look at a safety stop before the program goes on or ends. */
  void stopAtSafetyStops(boolean wanted);

  /** Whether a safety stop is to be looked at, and time stands still for that. */
  boolean atSafetyStop();

  /** Goes on after a safety stop. */
  void leaveSafetyStop();

  /** Ends the program. */
  void stop();

  /** Has done with the robot. */
  @Override
  void close();
}
