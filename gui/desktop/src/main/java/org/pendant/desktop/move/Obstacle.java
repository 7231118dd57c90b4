package org.pendant.desktop.move;

import java.util.Optional;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ArmReadiness;
import org.pendant.script.vm.ProgramState;

/**
 * Obstacle: why the arm cannot be moved by hand at the moment, and what helps.
 *
 * @param text why, and what to do, in a sentence or two
 * @param remedy what the button says; empty where none helps
 * @param command what the button does; empty while it cannot be done
 */
record Obstacle(String text, String remedy, Optional<Command> command) {
  /**
   * The fastest pace at which the arm can be moved by hand: the screen repeats what is held 30
   * times a second, and the arm waits a quarter of a second of robot time for it.
   */
  static final double MAX_PACE = 4;

  /** What is in the way; empty if nothing is. */
  static Optional<Obstacle> of(ControllerState state, Pace pace) {
    ArmReadiness readiness = ArmReadiness.of(state);
    boolean recovery = state.safety().safetyMode() == SafetyMode.RECOVERY;
    if (readiness.light() != ArmReadiness.Light.READY && !recovery) {
      String text =
          readiness.command().isPresent()
              ? MoveTexts.text("notReady", readiness.text())
              : MoveTexts.text("notReadyWithHint", readiness.text(), readiness.hint());
      return Optional.of(new Obstacle(text, readiness.remedy(), readiness.command()));
    }
    if (state.program().state() != ProgramState.STOPPED) {
      return Optional.of(program(state));
    }
    return pace(pace).or(() -> slider(state)).map(text -> new Obstacle(text, "", Optional.empty()));
  }

  private static Obstacle program(ControllerState state) {
    boolean paused = state.debug().held() || state.program().state() == ProgramState.PAUSED;
    return new Obstacle(
        MoveTexts.text(paused ? "programPaused" : "programRunning", state.program().name()),
        MoveTexts.text("stopProgram"),
        Optional.of(new ProgramCommand.StopProgram()));
  }

  private static Optional<String> pace(Pace pace) {
    return switch (pace) {
      case Pace.Paused paused -> Optional.of(MoveTexts.text("robotTimePaused"));
      case Pace.Unlimited unlimited -> Optional.of(tooFast());
      case Pace.Times times ->
          times.factor() > MAX_PACE ? Optional.of(tooFast()) : Optional.empty();
    };
  }

  private static String tooFast() {
    return MoveTexts.text("robotTimeTooFast");
  }

  private static Optional<String> slider(ControllerState state) {
    return state.arm().speedFraction() == 0
        ? Optional.of(MoveTexts.text("theSpeedSliderIsAt0"))
        : Optional.empty();
  }
}
