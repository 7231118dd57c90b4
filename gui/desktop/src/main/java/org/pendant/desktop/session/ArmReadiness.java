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
          "Shut down",
          "",
          Optional.empty(),
          "A program has switched the controller off; the menu Robot switches it on again");
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
              "Restart safety",
              Optional.of(new SafetyCommand.RestartSafety()),
              "Starts the safety functions again; the arm is without power then");
      default ->
          new ArmReadiness(
              Light.STOPPED,
              text,
              "",
              Optional.empty(),
              "Lasts until its safety input is released, on the I/O screen");
    };
  }

  private static ArmReadiness unlock(String text, double leftS) {
    if (leftS > 1e-6) {
      long seconds = (long) Math.ceil(leftS);
      return new ArmReadiness(
          Light.STOPPED,
          text,
          "Unlock in " + seconds + " s",
          Optional.empty(),
          "A protective stop can be unlocked 5 s of robot time after it happened");
    }
    return new ArmReadiness(
        Light.STOPPED,
        text,
        "Unlock",
        Optional.of(new SafetyCommand.UnlockProtectiveStop(false)),
        "Ends the protective stop; a program stays paused");
  }

  private static ArmReadiness power(ControllerState state) {
    String text = StateWords.capital(StateWords.of(state.safety().robotMode()));
    return switch (state.safety().robotMode()) {
      case RUNNING ->
          state.safety().safetyMode() == SafetyMode.RECOVERY
              ? new ArmReadiness(
                  Light.WAITING,
                  "Recovery",
                  "",
                  Optional.empty(),
                  "The arm is beyond a safety limit: bring it back by hand, on the Move screen")
              : new ArmReadiness(
                  Light.READY,
                  "Ready",
                  "Switch off",
                  Optional.of(new SafetyCommand.PowerOff()),
                  "Cuts the arm's power; a program ends");
      case POWER_OFF, IDLE ->
          new ArmReadiness(
              Light.OFF,
              text,
              "Switch on",
              Optional.of(new SafetyCommand.ReleaseBrakes()),
              "Powers the arm on and releases its brakes");
      case BACKDRIVE ->
          new ArmReadiness(
              Light.WAITING,
              text,
              "End backdrive",
              Optional.of(new SafetyCommand.EndBackdrive()),
              "Closes the brakes again");
      case NO_CONTROLLER, DISCONNECTED, CONFIRM_SAFETY, BOOTING, POWER_ON, UPDATING_FIRMWARE ->
          new ArmReadiness(
              Light.WAITING, text, "", Optional.empty(), "The arm is being switched on");
    };
  }
}
