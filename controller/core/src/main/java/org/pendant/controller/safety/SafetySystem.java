package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.world.LinkHit;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.force.TaskDeviation;

/**
 * Safety system: power, safety modes, limits and stops of one arm. The frame loop alone uses it:
 * requests and settings before {@link #step} of a frame take effect in it.
 */
public final class SafetySystem {
  private final ActiveLimits limits;
  private final ArmPower power;
  private final StopRecord stops;
  private final ArmDescription arm;
  private final ArmDynamics dynamics;
  private FrameChecks checks;
  private ViolationCheck positions;
  private volatile SafetyConfiguration configuration;
  private SafetyChecksum checksum;
  private final ArmPoints asked;
  private final MessageLog log;
  private final ErrorPauses pauses = new ErrorPauses();
  private final Set<SafetyInput> inputs = EnumSet.noneOf(SafetyInput.class);
  private final double[] askedQ = new double[Joints.COUNT];
  private final double[] atRest = new double[Joints.COUNT];
  private boolean holdingTorque = true;
  private final AskedStops askedStops = new AskedStops();
  private boolean jumped;
  private boolean wasRunning;
  private boolean wasReduced;
  private boolean shutDown;

  /**
   * A system that knows no payload; {@link #SafetySystem(ArmDescription, ArmDynamics,
   * SafetyConfiguration, MessageLog, boolean, PowerTimes)} is for a robot that carries things.
   */
  public SafetySystem(
      ArmDescription arm, SafetyConfiguration configuration, MessageLog log, boolean running) {
    this(arm, new ArmDynamics(arm), configuration, log, running, PowerTimes.STANDARD);
  }

  /**
   * A system that was just switched on.
   *
   * @param dynamics masses of arm and declared payload, kept up to date by the caller
   * @param log gets every stop and change of mode
   * @param running whether the arm is powered and its brakes are released already
   * @param times how long changes of power take
   */
  public SafetySystem(
      ArmDescription arm,
      ArmDynamics dynamics,
      SafetyConfiguration configuration,
      MessageLog log,
      boolean running,
      PowerTimes times) {
    this.arm = arm;
    this.dynamics = dynamics;
    this.configuration = configuration;
    limits = new ActiveLimits(arm, configuration);
    power = new ArmPower(times, running);
    stops = new StopRecord(log, times.unlockS());
    checks = new FrameChecks(arm, dynamics, configuration, new DeviationWarnings());
    positions = new ViolationCheck(configuration);
    checksum = SafetyChecksum.of(configuration);
    asked = new ArmPoints(arm);
    this.log = log;
  }

  /**
   * Other limits, planes and tool direction hold from now on. The arm is powered off, as a real one
   * is; no program may run.
   */
  public void configure(SafetyConfiguration configuration) {
    power.off();
    stops.poweredOff();
    this.configuration = configuration;
    limits.configure(configuration);
    checks = new FrameChecks(arm, dynamics, configuration, checks.warnings());
    positions = new ViolationCheck(configuration);
    checksum = SafetyChecksum.of(configuration);
  }

  /** Limits, planes and tool direction that hold; any thread may ask. */
  public SafetyConfiguration configuration() {
    return configuration;
  }

  /** Tells configurations apart. */
  public SafetyChecksum checksum() {
    return checksum;
  }

  /** How far the arm is switched on. */
  public RobotMode robotMode() {
    return power.mode();
  }

  /** What the safety functions do. */
  public SafetyMode safetyMode() {
    if (stop().isPresent()) {
      return stop().get().mode();
    }
    if (limits.recovery()) {
      return SafetyMode.RECOVERY;
    }
    return limits.reduced() ? SafetyMode.REDUCED : SafetyMode.NORMAL;
  }

  /** Why the arm is stopped, as long as it is. */
  public Optional<SafetyStop> stop() {
    return stops.present();
  }

  /** Whether a program asked for the present stop. */
  public boolean stoppedByProgram() {
    return stop().isPresent() && stop().get().code() == StopReason.PROGRAM.code();
  }

  /** The limits that hold now. */
  public SafetyLimits limits() {
    return limits.active();
  }

  /** Which limits hold, for those who must keep them. */
  ActiveLimits activeLimits() {
    return limits;
  }

  /** Whether the reduced limits hold. */
  public boolean reduced() {
    return limits.reduced();
  }

  /** The mode of joint {@code joint} (0 to 5). */
  public JointMode jointMode(int joint) {
    return JointMode.of(power.mode(), stop(), joint);
  }

  /** Momentum of arm and declared payload, kg m/s. */
  public double momentumKgMPerS() {
    return checks.momentumKgMPerS();
  }

  /**
   * How far the arm is from its target, as a share of what stops it (C153); 0 while that is not
   * looked at.
   */
  public double deviationRatio() {
    return watched() ? checks.deviationRatio() : 0;
  }

  /** How hard the arm is pushed, as a share of what stops it (C157); 0 as with the deviation. */
  public double collisionRatio() {
    return watched() ? checks.collisionRatio() : 0;
  }

  private boolean watched() {
    return power.running() && (stop().isEmpty() || stops.isSafeguard());
  }

  /** Powers the arm on; it gets to IDLE within 2 s. Answers why not, empty if it does. */
  public Optional<Refusal> powerOn() {
    Optional<Refusal> refusal = stops.powerRefusal(inputs);
    if (refusal.isEmpty()) {
      power.on();
    }
    return refusal;
  }

  /** Powers the arm off, which ends a protective stop. */
  public void powerOff() {
    power.turnOff();
    if (!power.turningOff()) {
      stops.poweredOff();
    }
  }

  /** Switches arm and controller off (manual 16.42); the thread that drives the frames sees it. */
  public void shutDown() {
    shutDown = true;
    powerOff();
  }

  /** Whether the controller has been switched off. */
  public boolean isShutDown() {
    return shutDown;
  }

  /**
   * Releases the brakes, within a second from IDLE; an arm that is off is powered on before.
   * Answers why not, empty if it does.
   */
  public Optional<Refusal> releaseBrakes() {
    if (power.mode() == RobotMode.BACKDRIVE) {
      return powerMode(text("backdriveFirst"));
    }
    Optional<Refusal> refusal = stops.powerRefusal(inputs);
    if (refusal.isEmpty()) {
      power.releaseBrakes();
    }
    return refusal;
  }

  /**
   * Ends a protective stop. Answers why not, empty if it does.
   *
   * @param early also within 5 s of the stop
   */
  public Optional<Refusal> unlockProtectiveStop(boolean early) {
    return stops.unlock(early);
  }

  /**
   * Starts the safety functions again after a violation or a fault; the arm is off then. Answers
   * why not, empty if it does.
   */
  public Optional<Refusal> restartSafety() {
    Optional<Refusal> refusal = stops.restart();
    if (refusal.isEmpty()) {
      power.off();
    }
    return refusal;
  }

  /** Lets a powered arm on its brakes be pushed about. Answers why not, empty if it does. */
  public Optional<Refusal> startBackdrive() {
    if (power.mode() != RobotMode.IDLE) {
      return powerMode(text("notIdleForBackdrive", power.mode()));
    }
    Optional<Refusal> refusal = stops.powerRefusal(inputs);
    if (refusal.isEmpty()) {
      power.startBackdrive();
    }
    return refusal;
  }

  /** Closes the brakes after {@link #startBackdrive}. Answers why not, empty if it does. */
  public Optional<Refusal> endBackdrive() {
    if (power.mode() != RobotMode.BACKDRIVE) {
      return powerMode(text("notInBackdrive", power.mode()));
    }
    power.endBackdrive();
    return Optional.empty();
  }

  /** Why no program may start or continue now; empty if one may. */
  public Optional<Refusal> programRefusal() {
    if (stop().isPresent()) {
      return Optional.of(stops.refusal());
    }
    Optional<Refusal> powerless = motionRefusal();
    return powerless.isPresent() ? powerless : recoveryRefusal();
  }

  /**
   * Why no program that is sent to a port may run now; empty if one may. It may without power,
   * which {@link #motionRefusal} is for.
   */
  public Optional<Refusal> uploadRefusal() {
    return stop().isPresent() ? Optional.of(stops.refusal()) : recoveryRefusal();
  }

  private Optional<Refusal> recoveryRefusal() {
    return limits.recovery()
        ? Optional.of(new Refusal(Refusal.Code.SAFETY, text("mustBeBroughtBack")))
        : Optional.empty();
  }

  /** Why the arm cannot move for want of power; empty if it has power and no brakes. */
  public Optional<Refusal> motionRefusal() {
    if (power.turningOff()) {
      return powerMode(text("beingPoweredOff"));
    }
    return power.running() ? Optional.empty() : powerMode(text("notRunning", power.mode()));
  }

  private static Optional<Refusal> powerMode(String text) {
    return Optional.of(new Refusal(Refusal.Code.ARM_POWER, text));
  }

  /** Demands a safety function, or no longer does. */
  public void setInput(SafetyInput input, boolean active) {
    if (active) {
      inputs.add(input);
    } else {
      inputs.remove(input);
    }
  }

  /**
   * Chooses manual mode, in which {@link SafetyInput#AUTOMATIC_MODE_SAFEGUARD_STOP} does not count.
   */
  public void setManualMode(boolean manual) {
    stops.setManual(manual);
  }

  /** Whether an input demands its safety function. */
  public boolean active(SafetyInput input) {
    return inputs.contains(input);
  }

  /** A program asks for a protective stop (manual 16.43). */
  public void protectiveStop() {
    askedStops.ofProgram();
  }

  /** The target has left a path that it could not follow: a protective stop in this frame. */
  public void lostPath(MotionFailure why) {
    askedStops.lostPath(why);
  }

  /**
   * Freedrive has found that the declared payload is wrong: a protective stop in this frame.
   *
   * @param forceN what the flange feels beyond the declared payload, N
   * @param toleranceN how much of that is allowed, N
   */
  public void wrongPayload(double forceN, double toleranceN) {
    askedStops.wrongPayload(forceN, toleranceN);
  }

  /**
   * The arm is too far aside for force mode (manual 15.12): a protective stop in this frame. One
   * that is stopped already stays as it is.
   */
  public void aside(TaskDeviation deviation) {
    askedStops.aside(deviation);
  }

  /** A link of the arm has got into something: a protective stop in this frame. */
  public void linkHit(LinkHit hit) {
    askedStops.linkHit(hit);
  }

  /**
   * How the arm changes to reduced limits and to a safeguard stop (manual 15.47). Lasts until
   * changed.
   *
   * @param type 0 for as hard as possible, which is the default, 1 for softly
   * @throws IllegalArgumentException for other types
   */
  public void setTransitionHardness(int type) {
    if (type != 0 && type != 1) {
      throw new IllegalArgumentException(text("transitionType", type));
    }
    limits.setSoft(type == 1);
  }

  /**
   * Pauses the program when the log gets an error with this code (manual 15.40), until the program
   * stops. A stop stays a stop.
   *
   * @param argument of the error; empty for any
   */
  public void pauseOnErrorCode(int code, OptionalInt argument) {
    pauses.add(code, argument);
  }

  /**
   * Warns when a joint is away from its target (manual 15.41). Lasts until changed.
   *
   * @param threshold share of the deviation that stops the arm, 0 to 1
   * @throws IllegalArgumentException for other thresholds
   */
  public void positionDeviationWarning(boolean enabled, double threshold) {
    if (!(threshold >= 0 && threshold <= 1)) {
      throw new IllegalArgumentException(text("warningThreshold", threshold));
    }
    checks.warnings().set(enabled, threshold);
  }

  /** Whether a resting arm resists with all its might (manual 16.37), as it does at first. */
  public void setHighHoldingTorque(boolean enabled) {
    holdingTorque = enabled;
  }

  /** A program has stopped: what it asked for no longer holds (manual 15.40). */
  public void programStopped() {
    pauses.clear();
  }

  /** The arm was put elsewhere: its target jumps in this frame, and rightly (manual 15.46). */
  public void jumped() {
    jumped = true;
  }

  /** How fast the fastest joint slows down in the present stop, rad/s². */
  public double stopDecelerationRadPerS2() {
    return limits.soft() && stops.isSafeguard()
        ? Stopping.SOFT_RAD_PER_S2
        : Stopping.HARD_RAD_PER_S2;
  }

  /**
   * Whether joint ranges, planes and tool direction that hold now allow a position (manual 16.40).
   */
  public boolean within(Joints positionRad, Pose tcpInFlange) {
    positionRad.copyTo(askedQ);
    asked.at(askedQ, atRest, tcpInFlange);
    return positions.position(0, askedQ, asked, limits.configuredActive(), reduced(), 0).isEmpty();
  }

  /** Looks at a frame, step 5 of it, and answers what has to be done. */
  public SafetyAction step(FrameFacts facts) {
    stepPower();
    checks.take(facts);
    stops.setTime(facts.timeS());
    Optional<SafetyStop> demanded = demanded(facts);
    askedStops.forget();
    jumped = false;
    if (demanded.isPresent() && stops.begin(demanded.get(), facts.programRunning())) {
      checks.restart();
      return begun(demanded.get().category());
    }
    return continueAsBefore(facts);
  }

  private void stepPower() {
    boolean turningOff = power.turningOff();
    power.step();
    if (turningOff && !power.turningOff()) {
      stops.poweredOff();
    }
  }

  private SafetyAction begun(StopCategory category) {
    return switch (category) {
      case ZERO -> {
        power.off();
        yield SafetyAction.OFF_NOW;
      }
      case ONE -> SafetyAction.STOP_ON_PATH_THEN_OFF;
      case TWO -> SafetyAction.STOP_ON_PATH;
    };
  }

  private SafetyAction continueAsBefore(FrameFacts facts) {
    if (stop().isPresent()) {
      if (stops.powerMayGo(facts.targetSpeedRadPerS()) && power.mode() != RobotMode.POWER_OFF) {
        power.off();
      }
      return stops.endWithInput(inputs, power.mode());
    }
    Optional<SafetyStop> warning =
        power.running() ? checks.warning(facts, holding(facts)) : Optional.empty();
    if (warning.isEmpty()) {
      return SafetyAction.NONE;
    }
    log.safety(Level.WARNING, warning.get().codeText(), warning.get().message());
    return facts.programRunning() && pauses.contains(warning.get())
        ? SafetyAction.PAUSE
        : SafetyAction.NONE;
  }

  /** The worst that calls for a stop in this frame. */
  private Optional<SafetyStop> demanded(FrameFacts facts) {
    Optional<SafetyStop> found = checks.fault(facts);
    if (found.isPresent()) {
      return found;
    }
    limits.update(facts.timeS(), active(SafetyInput.REDUCED_MODE), checks.actual());
    reportReduced();
    if (power.running()) {
      followRecovery(facts);
      found = checks.violation(facts, limits, stop().isPresent());
    } else {
      limits.setRecovery(false);
    }
    wasRunning = power.running();
    if (found.isEmpty()) {
      found = stops.emergency(inputs);
    }
    if (found.isEmpty() && power.running()) {
      found = protective(facts);
    }
    return found.isEmpty() ? stops.safeguard(inputs) : found;
  }

  private void followRecovery(FrameFacts facts) {
    if (!wasRunning) {
      checks.forget();
      enterRecovery(facts);
    } else if (limits.recovery() && checks.beyond(facts.timeS(), limits, 0).isEmpty()) {
      limits.setRecovery(false);
      log.safety(Level.INFO, "", text("withinLimitsAgain"));
    }
  }

  private void enterRecovery(FrameFacts facts) {
    Optional<SafetyStop> beyond = checks.beyond(facts.timeS(), limits, 1);
    if (beyond.isPresent() && !facts.programRunning()) {
      limits.setRecovery(true);
      log.safety(
          Level.WARNING, beyond.get().codeText(), text("recoveryMode", beyond.get().message()));
    }
  }

  private void reportReduced() {
    if (limits.reduced() != wasReduced) {
      wasReduced = limits.reduced();
      log.safety(Level.INFO, "", wasReduced ? text("reducedLimitsHold") : text("normalLimitsHold"));
    }
  }

  private Optional<SafetyStop> protective(FrameFacts facts) {
    Optional<SafetyStop> requested = checks.requested(askedStops, facts, limits());
    if (requested.isPresent()) {
      checks.acceptTarget();
      return requested;
    }
    if (stop().isPresent() && !stops.isSafeguard()) {
      checks.acceptTarget();
      return Optional.empty();
    }
    if (jumped) {
      checks.forget();
    }
    return checks.protective(facts, limits, holding(facts));
  }

  private boolean holding(FrameFacts facts) {
    return facts.steady() && holdingTorque;
  }
}
