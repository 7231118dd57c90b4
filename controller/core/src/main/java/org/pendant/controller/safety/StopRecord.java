package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.MessageLog;
import org.pendant.models.arm.JointNumbers;

/** Stop record: how the present stop begins, what replaces it, and what ends it. */
final class StopRecord {
  /** Shortest time between a protective stop and its end by people, s. */
  static final double UNLOCK_S = 5;

  /** Longest time until an emergency stop cuts the power, s. */
  static final double POWER_S = 0.5;

  /** Share of a frame that sums of frame times may be off. */
  private static final double ROUNDING_S = 1e-6;

  private final MessageLog log;
  private Optional<SafetyStop> present = Optional.empty();
  private boolean programGoesOn;
  private double nowS;
  private final double unlockTakesS;

  /** A person works beside the robot: what protects in automatic mode only does not count. */
  private boolean manual;

  /** When the present stop ends, as asked for. */
  private OptionalDouble unlockedAtS = OptionalDouble.empty();

  /**
   * No stop yet.
   *
   * @param unlockTakesS how long it takes to end a protective stop, s
   */
  StopRecord(MessageLog log, double unlockTakesS) {
    this.log = log;
    this.unlockTakesS = unlockTakesS;
  }

  void setTime(double timeS) {
    nowS = timeS;
    if (unlockedAtS.isPresent() && timeS > unlockedAtS.getAsDouble() - ROUNDING_S) {
      endUnlocked();
    }
  }

  void setManual(boolean manual) {
    this.manual = manual;
  }

  Optional<SafetyStop> present() {
    return present;
  }

  boolean is(SafetyMode mode) {
    return present.isPresent() && present.get().mode() == mode;
  }

  boolean isSafeguard() {
    return is(SafetyMode.SAFEGUARD_STOP) || is(SafetyMode.AUTOMATIC_MODE_SAFEGUARD_STOP);
  }

  private boolean isEmergency() {
    return is(SafetyMode.ROBOT_EMERGENCY_STOP) || is(SafetyMode.SYSTEM_EMERGENCY_STOP);
  }

  private boolean needsRestart() {
    return is(SafetyMode.VIOLATION) || is(SafetyMode.FAULT);
  }

  /** Makes a stop the present one, unless there is one that is as bad; returns whether it did. */
  boolean begin(SafetyStop stop, boolean programRunning) {
    if (!outranks(stop.mode())) {
      return false;
    }
    present = Optional.of(stop);
    unlockedAtS = OptionalDouble.empty();
    programGoesOn = isSafeguard() && programRunning;
    if (isSafeguard() || stop.code() == StopReason.PROGRAM.code()) {
      log.safety(Level.WARNING, stop.codeText(), stop.message());
    } else {
      log.safety(Level.ERROR, stop.codeText(), stop.message());
    }
    return true;
  }

  /** Whether a stop with this mode would replace what is present. */
  private boolean outranks(SafetyMode mode) {
    return present.isEmpty() || rank(mode) > rank(present.get().mode());
  }

  private static int rank(SafetyMode mode) {
    return switch (mode) {
      case FAULT, VIOLATION -> 5;
      case ROBOT_EMERGENCY_STOP -> 4;
      case SYSTEM_EMERGENCY_STOP -> 3;
      case PROTECTIVE_STOP -> 2;
      case SAFEGUARD_STOP, AUTOMATIC_MODE_SAFEGUARD_STOP -> 1;
      case NORMAL,
          REDUCED,
          RECOVERY,
          VALIDATE_JOINT_ID,
          UNDEFINED,
          SYSTEM_THREE_POSITION_ENABLING_STOP,
          TEACH_PENDANT_THREE_POSITION_ENABLING_STOP ->
          0;
    };
  }

  /** The emergency stop that an input demands. */
  Optional<SafetyStop> emergency(Set<SafetyInput> inputs) {
    Optional<SafetyStop> robot =
        demanded(inputs, SafetyInput.EMERGENCY_STOP, StopReason.ROBOT_EMERGENCY_STOP);
    return robot.isPresent()
        ? robot
        : demanded(inputs, SafetyInput.SYSTEM_EMERGENCY_STOP, StopReason.SYSTEM_EMERGENCY_STOP);
  }

  /** The safeguard stop that an input demands. */
  Optional<SafetyStop> safeguard(Set<SafetyInput> inputs) {
    Optional<SafetyStop> any =
        demanded(inputs, SafetyInput.SAFEGUARD_STOP, StopReason.SAFEGUARD_STOP);
    return any.isPresent() || manual
        ? any
        : demanded(
            inputs,
            SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP,
            StopReason.AUTOMATIC_MODE_SAFEGUARD_STOP);
  }

  private Optional<SafetyStop> demanded(
      Set<SafetyInput> inputs, SafetyInput input, StopReason reason) {
    return inputs.contains(input) && outranks(reason.mode())
        ? Optional.of(reason.ofInput(input, nowS))
        : Optional.empty();
  }

  /** Whether a stop of category 1 has come to its end: the power may go. */
  boolean powerMayGo(JointNumbers targetSpeedRadPerS) {
    return present.isPresent()
        && present.get().category() == StopCategory.ONE
        && (targetSpeedRadPerS.isZero() || nowS - present.get().timeS() > POWER_S - ROUNDING_S);
  }

  /** Ends a stop whose input is gone; the answer is RESUME if a program may continue by itself. */
  SafetyAction endWithInput(Set<SafetyInput> inputs, RobotMode robotMode) {
    Optional<SafetyInput> input = input();
    if (input.isEmpty()
        || (isSafeguard() ? safeguarded(inputs) : inputs.contains(input.get()))
        || (isEmergency() && robotMode != RobotMode.POWER_OFF)) {
      return SafetyAction.NONE;
    }
    boolean resume = programGoesOn;
    end();
    log.safety(Level.INFO, "", text("inputReleased", input.get().word()));
    return resume ? SafetyAction.RESUME : SafetyAction.NONE;
  }

  private boolean safeguarded(Set<SafetyInput> inputs) {
    return inputs.contains(SafetyInput.SAFEGUARD_STOP)
        || (!manual && inputs.contains(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP));
  }

  private void end() {
    present = Optional.empty();
    unlockedAtS = OptionalDouble.empty();
    programGoesOn = false;
  }

  /** The input that demands the present stop. */
  private Optional<SafetyInput> input() {
    if (present.isEmpty()) {
      return Optional.empty();
    }
    return switch (present.get().mode()) {
      case ROBOT_EMERGENCY_STOP -> Optional.of(SafetyInput.EMERGENCY_STOP);
      case SYSTEM_EMERGENCY_STOP -> Optional.of(SafetyInput.SYSTEM_EMERGENCY_STOP);
      case SAFEGUARD_STOP -> Optional.of(SafetyInput.SAFEGUARD_STOP);
      case AUTOMATIC_MODE_SAFEGUARD_STOP -> Optional.of(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP);
      case PROTECTIVE_STOP,
          VIOLATION,
          FAULT,
          NORMAL,
          REDUCED,
          RECOVERY,
          VALIDATE_JOINT_ID,
          UNDEFINED,
          SYSTEM_THREE_POSITION_ENABLING_STOP,
          TEACH_PENDANT_THREE_POSITION_ENABLING_STOP ->
          Optional.empty();
    };
  }

  /** The arm has no power: nothing has to be protected from it. */
  void poweredOff() {
    if (is(SafetyMode.PROTECTIVE_STOP)) {
      end();
    }
  }

  /**
   * Ends a protective stop, or says why not.
   *
   * @param early also within {@link #UNLOCK_S} of the stop
   */
  Optional<Refusal> unlock(boolean early) {
    if (!is(SafetyMode.PROTECTIVE_STOP)) {
      return refused(text("nothingToUnlock"));
    }
    double leftS = present.get().timeS() + UNLOCK_S - nowS;
    if (!early && leftS > ROUNDING_S) {
      return refused(text("unlockLater", Math.round(UNLOCK_S), Math.ceil(leftS * 10) / 10));
    }
    if (unlockTakesS > 0) {
      unlockedAtS = OptionalDouble.of(unlockedAtS.orElse(nowS + unlockTakesS));
    } else {
      endUnlocked();
    }
    return Optional.empty();
  }

  private void endUnlocked() {
    end();
    log.safety(Level.INFO, "", text("unlocked"));
  }

  /** Ends a violation or a fault, or says why not. */
  Optional<Refusal> restart() {
    if (!needsRestart()) {
      return refused(text("nothingToRestart"));
    }
    end();
    log.safety(Level.INFO, "", text("safetyRestarted"));
    return Optional.empty();
  }

  /** Why the arm may not be powered or its brakes released now. */
  Optional<Refusal> powerRefusal(Set<SafetyInput> inputs) {
    if (needsRestart()) {
      return Optional.of(refusal());
    }
    for (SafetyInput each : inputs) {
      if (each == SafetyInput.EMERGENCY_STOP || each == SafetyInput.SYSTEM_EMERGENCY_STOP) {
        return refused(text("releaseInputFirst", each.word()));
      }
    }
    return isEmergency() ? Optional.of(refusal()) : Optional.empty();
  }

  /** What the present stop forbids, and what ends it. */
  Refusal refusal() {
    SafetyStop stop = present.orElseThrow();
    return new Refusal(Refusal.Code.SAFETY, text(remedy(), stop.message()));
  }

  private static Optional<Refusal> refused(String text) {
    return Optional.of(new Refusal(Refusal.Code.SAFETY, text));
  }

  /** Key of a stop with what ends it. */
  private String remedy() {
    if (needsRestart()) {
      return "refusedUntilRestart";
    }
    if (isEmergency()) {
      return "refusedUntilPower";
    }
    return isSafeguard() ? "refusedUntilReleased" : "refusedUntilUnlocked";
  }
}
