package org.pendant.editors.dap.run;

import static org.pendant.editors.dap.run.DebuggedRunTexts.text;

import java.util.Optional;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StopPlace;
import org.pendant.motion.MotionFailure;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/**
 * Program follower: sees after each frame what became of the program, and does what nobody is there
 * to do: a program that paused itself continues, one that a safety function paused ends.
 */
final class ProgramFollower {
  /** An arm that is not at rest by then never will be. */
  private static final int MAX_FRAMES_TO_REST = 5_000;

  private final Robot robot;
  private final RunListener listener;
  private boolean started;
  private boolean asked;
  private Optional<SafetyStop> heldBy = Optional.empty();
  private int lastLine;
  private int framesAtEnd;

  ProgramFollower(Robot robot, RunListener listener) {
    this.robot = robot;
    this.listener = listener;
  }

  /** What is to happen next. */
  enum Next {
    /** Frames follow. */
    FRAMES,
    /** A safety stop is to be looked at first. */
    STAND_STILL,
    /** The program is over. */
    OVER
  }

  /**
   * After a frame.
   *
   * @param stopAtSafetyStops whether people want to look at a safety stop
   */
  Next see(ControllerState state, boolean stopAtSafetyStops) {
    if (state.program().line() > 0) {
      lastLine = state.program().line();
    }
    started |= !state.newProgramEvents().isEmpty();
    return switch (state.program().state()) {
      case RUNNING -> {
        asked = false;
        yield Next.FRAMES;
      }
      case PAUSED -> paused(state, stopAtSafetyStops);
      case STOPPED -> {
        if (!started) {
          yield Next.FRAMES;
        }
        framesAtEnd++;
        yield state.arm().moving() && framesAtEnd < MAX_FRAMES_TO_REST ? Next.FRAMES : Next.OVER;
      }
    };
  }

  private Next paused(ControllerState state, boolean stopAtSafetyStops) {
    if (asked) {
      return Next.FRAMES;
    }
    asked = true;
    Optional<SafetyStop> stop = state.safety().stop();
    if (stop.isEmpty()) {
      listener.note(text("pausedContinues", state.program().line()));
      var _ = robot.submit(new ProgramCommand.ResumeProgram());
      return Next.FRAMES;
    }
    heldBy = stop;
    if (stopAtSafetyStops) {
      return Next.STAND_STILL;
    }
    end();
    return Next.FRAMES;
  }

  /** No operator is here to end a safety stop: the program ends with it. */
  void end() {
    var _ = robot.submit(new ProgramCommand.StopProgram());
  }

  /** How it ended. */
  RunResult result(ControllerState state) {
    return switch (state.program().ending().orElse(new Ending.Stopped())) {
      case Ending.Finished _, Ending.Halted _ -> done();
      case Ending.Failed(var failure) ->
          new RunResult(
              failure.code().equals("internal-error")
                  ? RunResult.INTERNAL_ERROR
                  : RunResult.PROGRAM_FAILED,
              Optional.of(failure),
              Optional.empty(),
              failure.line());
      case Ending.Stopped _ -> {
        Optional<String> why =
            heldBy
                .or(() -> state.safety().stop())
                .map(SafetyStop::message)
                .or(() -> state.arm().fault().map(MotionFailure::message));
        yield why.isEmpty()
            ? done()
            : new RunResult(RunResult.PROGRAM_FAILED, Optional.empty(), why, stoppedInLine(state));
      }
    };
  }

  private static RunResult done() {
    return new RunResult(RunResult.DONE, Optional.empty(), Optional.empty(), 0);
  }

  /** The line of the program that a safety stop met, or the last one that it reached. */
  private int stoppedInLine(ControllerState state) {
    return state
        .safety()
        .stopPlace()
        .map(StopPlace::line)
        .filter(line -> line > 0)
        .orElse(lastLine);
  }

  /** Whether the program has begun and not ended. */
  boolean running(ControllerState state) {
    return started && state.program().state() != ProgramState.STOPPED;
  }
}
