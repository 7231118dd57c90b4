package org.pendant.desktop.session;

import java.util.Optional;
import org.pendant.controller.command.Command;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;

/**
 * Arm readiness: whether the arm is ready for programs, and the next step that brings it there.
 *
 * @param light how it looks from afar
 * @param text what is the case, such as {@code Power off}
 * @param remedy what the button says, such as {@code Switch on}; empty where nothing is to be done
 * @param command what the button does; empty while it cannot be done yet
 * @param hint what the button does or why it has to wait, as a sentence
 */
public record ArmReadiness(
    Light light, String text, String remedy, Optional<Command> command, String hint) {
  /** Shortest time between a protective stop and its end, s. */
  private static final double UNLOCK_S = 5;

  /** How it looks from afar. */
  public enum Light {
    /** Programs can run. */
    READY,
    /** On the way, or waiting for something harmless. */
    WAITING,
    /** Without power. */
    OFF,
    /** Stopped by a safety function. */
    STOPPED
  }

  /** How ready the arm is in {@code state}. */
  public static ArmReadiness of(ControllerState state) {
    if (state.safety().shutDown()) {
      return new ArmReadiness(
          Light.OFF,
          SessionTexts.text("shutDown"),
          "",
          Optional.empty(),
          SessionTexts.text("switchedOffByProgram"));
    }
    Optional<SafetyStop> stop = state.safety().stop();
    return stop.isPresent() ? stopped(stop.get(), state) : power(state);
  }

  private static ArmReadiness stopped(SafetyStop stop, ControllerState state) {
    String text = StateWords.capital(StateWords.of(stop.mode()));
    return switch (stop.mode()) {
      case PROTECTIVE_STOP -> unlock(text, stop.timeS() + UNLOCK_S - state.timeS());
      case VIOLATION, FAULT ->
          new ArmReadiness(
              Light.STOPPED,
              text,
              SessionTexts.text("restartSafety"),
              Optional.of(new SafetyCommand.RestartSafety()),
              SessionTexts.text("startsTheSafetyFunctionsAgain"));
      default ->
          new ArmReadiness(
              Light.STOPPED,
              text,
              "",
              Optional.empty(),
              SessionTexts.text("lastsUntilInputIsReleased"));
    };
  }

  private static ArmReadiness unlock(String text, double leftS) {
    if (leftS > 1e-6) {
      long seconds = (long) Math.ceil(leftS);
      return new ArmReadiness(
          Light.STOPPED,
          text,
          SessionTexts.text("unlockInS", seconds),
          Optional.empty(),
          SessionTexts.text("unlockAfter5s"));
    }
    return new ArmReadiness(
        Light.STOPPED,
        text,
        SessionTexts.text("unlock"),
        Optional.of(new SafetyCommand.UnlockProtectiveStop(false)),
        SessionTexts.text("endsTheStop"));
  }

  private static ArmReadiness power(ControllerState state) {
    String text = StateWords.capital(StateWords.of(state.safety().robotMode()));
    return switch (state.safety().robotMode()) {
      case RUNNING ->
          state.safety().safetyMode() == SafetyMode.RECOVERY
              ? new ArmReadiness(
                  Light.WAITING,
                  SessionTexts.text("recovery"),
                  "",
                  Optional.empty(),
                  SessionTexts.text("beyondLimit"))
              : new ArmReadiness(
                  Light.READY,
                  SessionTexts.text("ready"),
                  SessionTexts.text("switchOff"),
                  Optional.of(new SafetyCommand.PowerOff()),
                  SessionTexts.text("cutsTheArmsPowerAProgram"));
      case POWER_OFF, IDLE ->
          new ArmReadiness(
              Light.OFF,
              text,
              SessionTexts.text("switchOn"),
              Optional.of(new SafetyCommand.ReleaseBrakes()),
              SessionTexts.text("powersTheArmOn"));
      case BACKDRIVE ->
          new ArmReadiness(
              Light.WAITING,
              text,
              SessionTexts.text("endBackdrive"),
              Optional.of(new SafetyCommand.EndBackdrive()),
              SessionTexts.text("closesTheBrakesAgain"));
      case NO_CONTROLLER, DISCONNECTED, CONFIRM_SAFETY, BOOTING, POWER_ON, UPDATING_FIRMWARE ->
          new ArmReadiness(
              Light.WAITING,
              text,
              "",
              Optional.empty(),
              SessionTexts.text("theArmIsBeingSwitchedOn"));
    };
  }
}
