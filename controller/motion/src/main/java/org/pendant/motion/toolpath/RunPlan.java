package org.pendant.motion.toolpath;

import static org.pendant.motion.toolpath.ToolpathTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.MotionSample;
import org.pendant.motion.PlanningException;
import org.pendant.motion.ToolCurve;
import org.pendant.motion.ToolPathFollower;

/**
 * Run plan: a run that has been planned and checked along all of its path, so that nothing moves
 * that cannot be finished.
 *
 * @param motion empty if the tool is at the end already
 * @param endInWork where it takes the tool, in the work frame
 * @param from joint positions at its start, rad
 */
public record RunPlan(Optional<Motion> motion, Pose endInWork, Joints from) {
  /** How far apart the points are that are looked at, m. */
  private static final double LOOK_M = 0.005;

  private static final double LOOK_RAD = 0.1;

  /** A joint that turns further from one look to the next cannot follow the path, rad. */
  private static final double JUMP_RAD = 1.5;

  /** The slowest that a path may have to be for the sake of the joints, as part of its speed. */
  private static final double SLOWEST = 0.02;

  /**
   * What is to be planned.
   *
   * @param orders to run
   * @param firstId the number of the first
   * @param from joint positions at the start, rad
   * @param activeTcp the TCP of the program, in the flange frame
   */
  record Task(
      ArmDescription arm,
      ToolConfiguration toolConfiguration,
      boolean turnFree,
      List<QueuedMotion> orders,
      int firstId,
      Joints from,
      Pose activeTcp,
      DoubleSupplier speedFactor) {
    Task {
      orders = List.copyOf(orders);
    }

    /** About how many legs it has. */
    int legs() {
      int legs = 0;
      for (QueuedMotion queuedMotion : orders) {
        legs += queuedMotion instanceof QueuedMotion.Path path ? path.path().points().size() : 1;
      }
      return legs;
    }
  }

  /**
   * The motion, for an arm at rest.
   *
   * @param positionRad where it is
   * @throws PlanningException when it is not where the run was planned from
   */
  public Motion begin(Joints positionRad) throws PlanningException {
    if (!positionRad.equals(from)) {
      throw new PlanningException("robot-in-use", text("movedMeanwhile"));
    }
    return motion.orElseThrow();
  }

  /**
   * Plans; takes about as long as the way is, so not for the frame loop.
   *
   * @throws PlanningException when some part of the way is impossible
   */
  static RunPlan of(Task task) throws PlanningException {
    ArmDescription arm = task.arm();
    ToolConfiguration toolConfiguration = task.toolConfiguration();
    Pose flange = new ForwardKinematics(arm).flangePose(task.from());
    Route route = new Route(toolConfiguration.toolAt(flange), task.turnFree());
    for (int i = 0; i < task.orders().size(); i++) {
      route.add(task.orders().get(i), task.firstId() + i);
    }
    if (route.legs().isEmpty()) {
      return new RunPlan(Optional.empty(), route.end(), task.from());
    }
    Chain chain = Chaining.of(route.legs());
    ToolCurve inWork =
        task.turnFree()
            ? new RotatedSegment(chain, FreeTurn.along(arm, chain, toolConfiguration, task.from()))
            : chain;
    ToolPathFollower follower =
        new ToolPathFollower(
            arm,
            toolConfiguration.curve(inWork),
            toolConfiguration.followerInFlange(),
            task.from());
    Joints last = look(arm, chain, follower, task.from());
    follower.restart(task.from());
    Pose end = new ForwardKinematics(arm).flangePose(last);
    Motion motion =
        new ToolpathMotion(
            chain,
            new SpeedLaw(chain),
            follower,
            Poses.trans(end, task.activeTcp()),
            task.speedFactor());
    return new RunPlan(Optional.of(motion), toolConfiguration.toolAt(end), task.from());
  }

  /** Goes along all of the way; joint positions at its end. */
  private static Joints look(
      ArmDescription arm, Chain chain, ToolPathFollower follower, Joints from)
      throws PlanningException {
    MotionSample sample = new MotionSample();
    double[] twist = new double[Pose.SIZE];
    Joints before = from;
    for (int i = 0; i < chain.pieces().size(); i++) {
      Chain.Piece piece = chain.pieces().get(i);
      piece.curve().rate(piece.from(), twist);
      double turn = Math.hypot(twist[3], Math.hypot(twist[4], twist[5]));
      double apart = Math.min(LOOK_M, LOOK_RAD / turn);
      int looks = (int) Math.ceil(piece.length() / apart);
      for (int k = 1; k <= looks; k++) {
        double at = chain.begin(i) + piece.length() * k / looks;
        Optional<MotionFailure> failure = follower.sample(at, piece.speed(), 0, sample);
        if (failure.isPresent()) {
          throw new PlanningException(
              failure.get().code(), piece.name() + ": " + failure.get().message());
        }
        refuseTooFast(arm, sample.speedRadPerS(), piece.name());
        refuseJump(arm, before, sample.positionRad(), piece.name());
        before = sample.positionRad();
      }
    }
    return before;
  }

  private static void refuseJump(ArmDescription arm, Joints before, Joints after, String name)
      throws PlanningException {
    if (before.maxAbsDifference(after) <= JUMP_RAD) {
      return;
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits limit = arm.joints().get(i);
      double q = before.get(i);
      if (Math.min(q - limit.lowestRad(), limit.highestRad() - q) < 2 * LOOK_RAD) {
        throw new PlanningException("no-solution", text("rangeEnds", name, i, degrees(q)));
      }
    }
    throw new PlanningException("singularity", text("throughSingularity", name));
  }

  private static long degrees(double rad) {
    return Math.round(Math.toDegrees(rad));
  }

  private static void refuseTooFast(ArmDescription arm, Joints speedRadPerS, String name)
      throws PlanningException {
    List<JointLimits> limits = arm.joints();
    for (int i = 0; i < Joints.COUNT; i++) {
      if (Math.abs(speedRadPerS.get(i)) * SLOWEST > limits.get(i).maxSpeedRadPerS()) {
        throw new PlanningException(
            "singularity",
            text("nearSingularity", name, i, Math.round(Math.abs(speedRadPerS.get(i)))));
      }
    }
  }
}
