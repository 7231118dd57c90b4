package org.pendant.motion.force;

import static org.pendant.motion.force.ForceTexts.text;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;
import org.pendant.models.text.FloatText;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionControl;
import org.pendant.motion.PathLimiter;
import org.pendant.motion.PathOffset;
import org.pendant.motion.PlanningException;
import org.pendant.motion.StopJ;

/**
 * Force mode: the TCP gives way along some axes until the tool presses with a wanted wrench (manual
 * 15.12). It is carried aside from the path of moves, which continue meanwhile; the speed slider
 * does not slow giving way. A pause or a stop ends giving way until the program continues.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class ForceMode implements PathOffset {
  private enum Phase {
    OFF,
    ON,
    /** What is carried stays as it is until the moves that are under way have ended. */
    ENDING
  }

  private static final int N = ForceTask.AXES;

  private final MotionControl motion;
  private final TaskAxes axes = new TaskAxes();
  private final FeltWrench felt;
  private final Compliance compliance = new Compliance();
  private final ComplianceLimiter complianceLimiter;
  private final DeviationWatch deviations;
  private final ComplianceOffset complianceOffset = new ComplianceOffset();
  private final double[] onPath12 = new double[Transforms.SIZE];
  private final double[] tool12 = new double[Transforms.SIZE];
  private final double[] pathTwist = new double[N];
  private final double[] twist = new double[N];
  private final double[] next = new double[N];
  private Pose tcpInFlange = Pose.ZERO;
  private Phase phase = Phase.OFF;
  private ForceTask task = ForceTask.rigid();

  /** Whether {@link #onPath12} is where the path was in the last frame. */
  private boolean pathKnown;

  /**
   * What force mode works with.
   *
   * @param arm what the arm is made of
   * @param pushed the arm whose tool feels something
   * @param flangeWrenchInBase what acts on the tool from outside, at the flange along the axes of
   *     the base
   * @param speeds knows how fast the arm may go
   * @param limits the safety limits that hold now
   */
  public record Setup(
      ArmDescription arm,
      MeasuredArm pushed,
      Supplier<Wrench> flangeWrenchInBase,
      PathLimiter speeds,
      Supplier<? extends JointPositionLimits> limits,
      MotionControl motion) {}

  /** Force mode that is off; nothing else may carry the TCP after it. */
  public ForceMode(Setup setup) {
    motion = setup.motion();
    felt = new FeltWrench(setup.pushed(), setup.flangeWrenchInBase());
    complianceLimiter =
        new ComplianceLimiter(setup.arm(), setup.speeds(), setup.limits(), setup.pushed());
    deviations = new DeviationWatch(setup.arm());
    Transforms.of(tcpInFlange, tool12);
    motion.addOffset(this);
  }

  /**
   * Gives way from now on. If force mode is on already it continues with the other task, from the
   * speed that it has; the path is then where the TCP is, unless a move is under way.
   *
   * @param tcpInBase where the TCP is to be now
   * @throws PlanningException in freedrive, and when the point to turn to is too near
   */
  public void start(ForceTask wanted, Pose tcpInBase) throws PlanningException {
    if (motion.guided()) {
      throw new PlanningException("freedrive", text("inFreedrive"));
    }
    if (motion.torqueDriven()) {
      throw new PlanningException("robot-in-use", text("drivenByTorques"));
    }
    if (phase == Phase.ON && wanted.equals(task)) {
      return;
    }
    if (wanted.kind() == FrameKind.POINT) {
      refuseNearPoint(wanted.taskFrame(), tcpInBase);
    }
    if (phase == Phase.OFF) {
      stand();
    } else if (!motion.moving()) {
      motion.endOffset(this);
    }
    task = wanted;
    axes.begin(wanted);
    deviations.setTask(wanted);
    phase = Phase.ON;
  }

  private static void refuseNearPoint(Pose origin, Pose tcp) throws PlanningException {
    double distance =
        Math.sqrt(
            Math.pow(origin.x() - tcp.x(), 2)
                + Math.pow(origin.y() - tcp.y(), 2)
                + Math.pow(origin.z() - tcp.z(), 2));
    if (distance < TaskAxes.NEAREST_POINT_M) {
      throw new PlanningException(
          "value-out-of-range",
          text("nearPoint", FloatText.of(distance), FloatText.of(TaskAxes.NEAREST_POINT_M)));
    }
  }

  /** Nothing moves beside the path, and nothing is carried. */
  private void stand() {
    forget();
    rest();
  }

  private void forget() {
    complianceOffset.clear();
    pathKnown = false;
  }

  /**
   * Ends force mode (manual 15.8): the arm comes to rest from where it is. While a move is under
   * way the TCP stays as far from its path as it is.
   */
  public void finish() {
    if (phase == Phase.ON) {
      phase = Phase.ENDING;
      if (!motion.moving()) {
        settle();
      }
    }
  }

  /** Looks whether what is carried still has to be; after the motion of a frame. */
  public void follow() {
    if (phase == Phase.ENDING && !motion.moving()) {
      settle();
    }
  }

  private void settle() {
    try {
      motion.endOffset(this);
      if (motion.turning()) {
        motion.takeOver(ForceMode::stop).cancel();
      }
    } catch (PlanningException e) {
      throw new IllegalStateException("the arm is in use without moving", e);
    }
  }

  private static Motion stop(Joints positionRad, Joints speedRadPerS) {
    return new StopJ(positionRad, speedRadPerS, MotionControl.SCALING_ACCELERATION_RAD_PER_S2);
  }

  /** The arm rests beside its path, which begins anew there: force mode stays on if it was. */
  public void continueFrom(Runnable elsewhere) {
    boolean wasOn = on();
    elsewhere.run();
    if (wasOn) {
      stand();
      phase = Phase.ON;
    }
  }

  /** Whether force mode is on; it may still carry the TCP afterwards, until moves have ended. */
  public boolean on() {
    return phase == Phase.ON;
  }

  /** The share of its speed that the TCP loses in each frame (manual 15.16). */
  public double damping() {
    return compliance.damping();
  }

  /**
   * Changes the damping, at once.
   *
   * @param share 0 to 1
   */
  public void setDamping(double share) {
    compliance.setDamping(share);
  }

  /** How strongly the TCP answers to forces (manual 15.17). */
  public double gainScaling() {
    return compliance.gain();
  }

  /**
   * Changes the gain scaling, at once.
   *
   * @param scaling 0 to 2
   */
  public void setGainScaling(double scaling) {
    compliance.setGain(scaling);
  }

  /** A program starts: damping and gain are as usual. */
  public void programStarted() {
    compliance.setDamping(Compliance.DEFAULT_DAMPING);
    compliance.setGain(Compliance.DEFAULT_GAIN);
  }

  /** The force sensor has another zero, or feels another payload. */
  public void sensorChanged() {
    felt.forget();
  }

  /** Another TCP is active; the arm stays where it is. */
  public void setTool(Pose inFlange) {
    if (pathKnown) {
      double[] flangeInTcp = new double[Transforms.SIZE];
      double[] flange = new double[Transforms.SIZE];
      Transforms.invert(tool12, flangeInTcp);
      Transforms.multiply(onPath12, flangeInTcp, flange);
      double x = onPath12[9];
      double y = onPath12[10];
      double z = onPath12[11];
      Transforms.of(inFlange, tool12);
      Transforms.multiply(flange, tool12, onPath12);
      complianceOffset.movePoint(onPath12[9] - x, onPath12[10] - y, onPath12[11] - z);
    }
    Transforms.of(inFlange, tool12);
    tcpInFlange = inFlange;
    deviations.setTool(inFlange);
    felt.forget();
  }

  /**
   * Looks whether the arm has been pushed too far aside where it does not give way; after the arm
   * has moved. While a pause or a stop holds the arm, and for screw driving, there is no limit.
   *
   * @param targetRad where the joints are to be, what is carried included
   * @param actualRad where they are
   * @return what calls for a protective stop
   */
  public Optional<TaskDeviation> deviation(JointNumbers targetRad, JointNumbers actualRad) {
    if (!givesWay()) {
      deviations.forget();
      return Optional.empty();
    }
    return deviations.look(axes, targetRad, actualRad);
  }

  private boolean givesWay() {
    return phase == Phase.ON && !motion.paused() && motion.fault().isEmpty();
  }

  @Override
  public boolean active() {
    return phase != Phase.OFF;
  }

  @Override
  public void apply(double[] tcpInBase) {
    seePath(tcpInBase);
    complianceOffset.apply(tcpInBase);
    axes.update(tcpInBase, pathTwist);
    felt.feel(tcpInFlange);
    if (givesWay()) {
      compliance.step(task, axes, felt, pathTwist, complianceOffset, twist, next);
    } else {
      Arrays.fill(next, 0);
    }
    complianceLimiter.limit(motion, tcpInFlange, pathTwist, twist, next);
    System.arraycopy(next, 0, twist, 0, N);
    complianceOffset.advance(twist);
    System.arraycopy(onPath12, 0, tcpInBase, 0, Transforms.SIZE);
    complianceOffset.apply(tcpInBase);
  }

  /** How the path has moved the TCP since the last frame. */
  private void seePath(double[] tcp12) {
    Arrays.fill(pathTwist, 0);
    if (pathKnown) {
      double f = 1 / FrameTime.FRAME_S;
      for (int i = 0; i < 3; i++) {
        pathTwist[i] = f * (tcp12[9 + i] - onPath12[9 + i]);
      }
      pathTwist[3] = f * turned(tcp12, 2, 1);
      pathTwist[4] = f * turned(tcp12, 0, 2);
      pathTwist[5] = f * turned(tcp12, 1, 0);
    }
    System.arraycopy(tcp12, 0, onPath12, 0, Transforms.SIZE);
    pathKnown = true;
  }

  /** An element of the rotation since the last frame: for small angles the rotation vector. */
  private double turned(double[] tcp12, int row, int other) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      sum +=
          tcp12[3 * row + i] * onPath12[3 * other + i]
              - tcp12[3 * other + i] * onPath12[3 * row + i];
    }
    return sum / 2;
  }

  @Override
  public void rest() {
    Arrays.fill(twist, 0);
    felt.forget();
  }

  @Override
  public void rebase(double[] tcpInBase, int framesAgo) {
    complianceOffset.undo(tcpInBase, framesAgo);
  }

  @Override
  public void end() {
    phase = Phase.OFF;
    forget();
  }
}
