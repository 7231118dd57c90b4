package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import java.util.Optional;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;

/**
 * Program controls: what may be done with the program at the moment. A reason is empty where the
 * thing may be done.
 *
 * @param phase of the program
 * @param whyNoRun why it cannot be started or resumed
 * @param whyNoPause why it cannot be paused
 * @param whyNoStop why it cannot be stopped
 * @param whyNoStep why it cannot be held or run to its next line
 */
public record ProgramControls(
    ProgramPhase phase, String whyNoRun, String whyNoPause, String whyNoStop, String whyNoStep) {

  /** What {@code state} allows. */
  public static ProgramControls of(ControllerState state) {
    ProgramPhase phase = ProgramPhase.of(state);
    // What the debugger has paused continues in the middle of a frame, whatever the arm does.
    String refusal = state.debug().held() ? "" : refusal(state).orElse("");
    return switch (phase) {
      case STOPPED ->
          new ProgramControls(
              phase, refusal, text("noProgramIsRunning"), text("noProgramIsRunning"), refusal);
      case RUNNING -> new ProgramControls(phase, text("theProgramIsRunning"), "", "", "");
      case PAUSED ->
          new ProgramControls(phase, refusal, text("theProgramIsPausedAlready"), "", refusal);
    };
  }

  private static Optional<String> refusal(ControllerState state) {
    if (state.safety().shutDown()) {
      return Optional.of(text("switchItOnAgain"));
    }
    SafetyMode safety = state.safety().safetyMode();
    if (safety != SafetyMode.NORMAL && safety != SafetyMode.REDUCED) {
      return Optional.of(text("notDuring", StateWords.of(safety)));
    }
    RobotMode robot = state.safety().robotMode();
    return robot == RobotMode.RUNNING ? Optional.empty() : Optional.of(text("armIsNotReady"));
  }

  /** Whether Run starts a program from its beginning. */
  public boolean canStart() {
    return whyNoRun.isEmpty() && phase == ProgramPhase.STOPPED;
  }

  /** Whether Run resumes a paused program. */
  public boolean canResume() {
    return whyNoRun.isEmpty() && phase == ProgramPhase.PAUSED;
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
