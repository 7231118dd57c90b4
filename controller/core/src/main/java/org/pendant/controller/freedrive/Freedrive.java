package org.pendant.controller.freedrive;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.pendant.controller.arm.ArmCommand;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetySystem;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.motion.MotionControl;
import org.pendant.motion.PathLimiter;
import org.pendant.motion.PlanningException;

/**
 * Freedrive: the arm is guided by hand (manual 15.18). Its drives hold the weight that the
 * controller believes in, so a payload that is declared wrongly makes it drift; {@link Resistance}
 * keeps it slow enough and within the ranges of its joints, {@link AxisConstraint} on the axes that
 * are free. The target follows the arm, so that whatever comes afterwards starts where the arm is.
 *
 * <p>The safety functions stay on; any stop ends freedrive. Only the collision check rests, as a
 * push is what is wanted.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class Freedrive {
  private static final int N = Joints.COUNT;

  private final ArmDescription arm;
  private final SimulatedArm guided;
  private final SafetySystem safety;
  private final MotionControl motion;
  private final Supplier<Payload> declared;
  private final PayloadCheck payloadCheck;
  private final AxisConstraint lock;
  private final Resistance resistance;
  private final SensedPush push;
  private final double[] q = new double[N];
  private final double[] qd = new double[N];
  private final double[] torqueNm = new double[N];
  private final double[] dampingNmSPerRad = new double[N];
  private Pose tcpInFlange = Pose.ZERO;
  private Optional<FreedriveMode> mode = Optional.empty();

  /**
   * What freedrive works with.
   *
   * @param arm what the arm is made of
   * @param model masses of arm and declared payload, kept up to date by the caller
   * @param declared the payload that holds now
   * @param felt what an external sensor feels beside what truly pushes the arm, at the flange along
   *     the axes of the base
   * @param speeds knows how fast the arm may go
   */
  public record Setup(
      ArmDescription arm,
      SimulatedArm guided,
      ArmDynamics model,
      Supplier<Payload> declared,
      Supplier<Wrench> felt,
      SafetySystem safety,
      PathLimiter speeds,
      MotionControl motion) {}

  /** An arm that is not guided. */
  public Freedrive(Setup setup) {
    arm = setup.arm();
    guided = setup.guided();
    safety = setup.safety();
    motion = setup.motion();
    declared = setup.declared();
    payloadCheck = new PayloadCheck(arm);
    lock = new AxisConstraint(arm, setup.model());
    push = new SensedPush(arm, setup.felt());
    resistance = new Resistance(arm, setup.speeds());
  }

  /**
   * Lets the arm be guided from now on; an arm that is guided already begins anew in this way. An
   * operator at the screen may do so in recovery too: that is how the arm gets back.
   */
  public FreedriveStart start(FreedriveMode wanted) {
    boolean recovering =
        wanted.holder() != FreedriveHolder.PROGRAM && safety.safetyMode() == SafetyMode.RECOVERY;
    Optional<Refusal> refusal = recovering ? Optional.empty() : safety.programRefusal();
    if (refusal.isPresent()) {
      return new FreedriveStart.Refused(refusal.get());
    }
    OptionalDouble error =
        wanted.payloadChecked()
            ? payloadCheck.errorN(guided, declared.get())
            : OptionalDouble.empty();
    if (error.isPresent()) {
      return new FreedriveStart.WrongPayload(error.getAsDouble(), payloadCheck.toleranceN());
    }
    try {
      motion.startGuidance();
    } catch (PlanningException e) {
      return new FreedriveStart.Refused(new Refusal(Refusal.Code.ARM_RANGE, e.getMessage()));
    }
    guided.sensors().copyPositionRad(q);
    lock.begin(wanted.axes(), wanted.frame(), tcpInFlange, q);
    resistance.begin(q);
    mode = Optional.of(wanted);
    return new FreedriveStart.Started();
  }

  /** The arm is kept where it is, or comes to rest soon if it moves. */
  public void end() {
    if (mode.isPresent()) {
      mode = Optional.empty();
      motion.endGuidance();
    }
  }

  /** As {@link #end}, if this one asked for it. */
  public void end(FreedriveHolder holder) {
    if (heldBy(holder)) {
      end();
    }
  }

  /** Whether the arm is guided. */
  public boolean active() {
    return mode.isPresent();
  }

  /** The active tool centre point is another one; it is kept where it is. */
  public void setTool(Pose inFlange) {
    tcpInFlange = inFlange;
    if (active()) {
      guided.sensors().copyPositionRad(q);
      lock.setTool(inFlange, q);
    }
  }

  /** Another payload holds: a wrong one stops a guided arm, unless it need not be checked. */
  public void payloadChanged() {
    if (mode.isEmpty() || !mode.get().payloadChecked()) {
      return;
    }
    OptionalDouble error = payloadCheck.errorN(guided, declared.get());
    if (error.isPresent()) {
      safety.wrongPayload(error.getAsDouble(), payloadCheck.toleranceN());
    }
  }

  /** What the drives do in the frame that begins. */
  public ArmCommand command() {
    guided.sensors().copyPositionRad(q);
    guided.sensors().copySpeedRadPerS(qd);
    Arrays.fill(torqueNm, 0);
    push.add(q, torqueNm);
    lock.add(q, qd, torqueNm);
    double singularity =
        lock.locks() ? SingularityDistance.measure(arm.dh(), guided.positionRad()) : 1;
    resistance.add(safety.limits(), singularity, q, qd, torqueNm, dampingNmSPerRad);
    return new ArmCommand.Guide(Joints.of(torqueNm), Joints.of(dampingNmSPerRad));
  }

  /** The arm has moved: the target follows it. */
  public void follow(Joints positionRad, Joints speedRadPerS) {
    motion.guide(positionRad, speedRadPerS);
  }

  /** How the arm is guided; empty while it is not. */
  public Optional<FreedriveMode> mode() {
    return mode;
  }

  /** Whether it is guided, and this one asked for it. */
  public boolean heldBy(FreedriveHolder holder) {
    return mode.isPresent() && mode.get().holder() == holder;
  }

  /** How near a singularity is (manual 15.21). */
  public SingularityDistance singularity() {
    return SingularityDistance.at(arm.dh(), guided.positionRad());
  }
}
