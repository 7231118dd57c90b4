package org.pendant.desktop.session;

import java.util.Optional;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/**
 * Program controls: what may be done with the program at the moment. A reason is empty where the
 * thing may be done.
 *
 * @param state of the program
 * @param whyNoRun why it cannot be started or continued
 * @param whyNoPause why it cannot be paused
 * @param whyNoStop why it cannot be stopped
 * @param whyNoStep why it cannot be held or run to its next line
 */
public record ProgramControls(
    ProgramState state, String whyNoRun, String whyNoPause, String whyNoStop, String whyNoStep) {

  /** What {@code state} allows. */
  public static ProgramControls of(ControllerState state) {
    ProgramState program = state.program().state();
    boolean held = state.debug().held();
    boolean running = program == ProgramState.RUNNING && !held;
    boolean paused = program == ProgramState.PAUSED && !held;
    boolean stopped = program == ProgramState.STOPPED;
    String refusal = refusal(state).orElse("");
    return new ProgramControls(
        program,
        running ? "The program is running" : held ? "" : refusal,
        running ? "" : held ? "The debugger has paused the program" : "No program is running",
        stopped ? "No program is running" : "",
        paused ? "The program is paused: resume it first" : stopped ? refusal : "");
  }

  private static Optional<String> refusal(ControllerState state) {
    if (state.safety().shutDown()) {
      return Optional.of("A program has switched the controller off: switch it on again");
    }
    SafetyMode safety = state.safety().safetyMode();
    if (safety != SafetyMode.NORMAL && safety != SafetyMode.REDUCED) {
      return Optional.of("Not during " + StateWords.of(safety));
    }
    RobotMode robot = state.safety().robotMode();
    return robot == RobotMode.RUNNING
        ? Optional.empty()
        : Optional.of("The arm is not ready: switch it on first");
  }

  /** Whether Run starts a program from its beginning. */
  public boolean canStart() {
    return whyNoRun.isEmpty() && state == ProgramState.STOPPED;
  }

  /** Whether Run continues with a paused program. */
  public boolean canResume() {
    return whyNoRun.isEmpty() && state != ProgramState.STOPPED;
  }

  /** Whether Run does anything. */
  public boolean canRun() {
    return whyNoRun.isEmpty();
  }

  /** Whether there is a program to pause. */
  public boolean canPause() {
    return whyNoPause.isEmpty();
  }

  /** Whether there is a program to stop. */
  public boolean canStop() {
    return whyNoStop.isEmpty();
  }
}
