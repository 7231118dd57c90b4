package org.pendant.motion.force;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;

/**
 * Deviation monitor: checks that the TCP stays near its target along and about the axes that are
 * not compliant (manual 15.12). A frame in which it does allocates nothing.
 */
final class DeviationWatch {
  /** Limits below this count as this much: an arm that moves lags behind a little, m. */
  static final double MIN_M = 1e-3;

  /** As {@link #MIN_M}, rad. */
  static final double MIN_RAD = 5e-3;

  /** Frames in a row that count: 20 ms, as for a joint. */
  static final int FRAMES = (int) FrameTime.framesFor(0.02);

  private final DhLengths dh;
  private final ForwardKinematics forward;
  private final int[] beyond = new int[ForceTask.AXES];
  private final double[] target = new double[Joints.COUNT];
  private final double[] actual = new double[Joints.COUNT];
  private final double[] tool12 = new double[Transforms.SIZE];
  private final double[] flange12 = new double[Transforms.SIZE];
  private final double[] target12 = new double[Transforms.SIZE];
  private final double[] actual12 = new double[Transforms.SIZE];
  private final double[] turn9 = new double[9];

  /** From the target to where the TCP is: a way and a rotation vector in the base frame. */
  private final double[] aside = new double[ForceTask.AXES];

  private ForceTask task = ForceTask.rigid();
  private Pose tcpInFlange = Pose.ZERO;

  /** Joints that are away from their targets by less, all together, cannot be too far, rad. */
  private double harmlessRad = Double.POSITIVE_INFINITY;

  DeviationWatch(ArmDescription arm) {
    dh = arm.dh();
    forward = new ForwardKinematics(arm);
    setTool(Pose.ZERO);
  }

  /** Another task counts from now on; what has lasted until now continues. */
  void setTask(ForceTask wanted) {
    task = wanted;
    findHarmless();
  }

  void setTool(Pose inFlange) {
    tcpInFlange = inFlange;
    Transforms.of(inFlange, tool12);
    findHarmless();
  }

  private void findHarmless() {
    // no TCP is further than this from the axis of a joint
    double reachM =
        Math.abs(dh.a2())
            + Math.abs(dh.a3())
            + Math.abs(dh.d4())
            + Math.abs(dh.d5())
            + Math.abs(dh.d6())
            + Math.sqrt(
                tcpInFlange.x() * tcpInFlange.x()
                    + tcpInFlange.y() * tcpInFlange.y()
                    + tcpInFlange.z() * tcpInFlange.z());
    harmlessRad = Double.POSITIVE_INFINITY;
    for (int i = 0; i < ForceTask.AXES; i++) {
      harmlessRad = Math.min(harmlessRad, i < 3 ? limit(i) / reachM : limit(i));
    }
  }

  /** How far the TCP may be from its target along or about an axis, m or rad. */
  private double limit(int i) {
    ForceAxis axis = task.axes().get(i);
    if (axis.compliant()) {
      return Double.POSITIVE_INFINITY;
    }
    return Math.max(axis.limit(), i < 3 ? MIN_M : MIN_RAD);
  }

  /** What was seen before does not count. */
  void forget() {
    Arrays.fill(beyond, 0);
  }

  /**
   * Looks at a frame.
   *
   * @param axes of the task frame as it is now
   * @param targetRad where the joints are to be
   * @param actualRad where they are
   * @return an axis along which the TCP has been too far away for 20 ms
   */
  Optional<TaskDeviation> look(TaskAxes axes, JointNumbers targetRad, JointNumbers actualRad) {
    targetRad.copyTo(target);
    actualRad.copyTo(actual);
    double sum = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      sum += Math.abs(target[i] - actual[i]);
    }
    if (sum <= harmlessRad || !axes.known()) {
      forget();
      return Optional.empty();
    }
    measure();
    Optional<TaskDeviation> found = Optional.empty();
    for (int i = 0; i < ForceTask.AXES; i++) {
      double amount = Math.abs(axes.along(i % 3, aside, i < 3 ? 0 : 3));
      beyond[i] = amount > limit(i) ? beyond[i] + 1 : 0;
      if (beyond[i] >= FRAMES && found.isEmpty()) {
        found = Optional.of(new TaskDeviation(i, amount, limit(i)));
      }
    }
    return found;
  }

  private void measure() {
    forward.flange(target, flange12);
    Transforms.multiply(flange12, tool12, target12);
    forward.flange(actual, flange12);
    Transforms.multiply(flange12, tool12, actual12);
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        turn9[3 * row + column] =
            actual12[3 * row] * target12[3 * column]
                + actual12[3 * row + 1] * target12[3 * column + 1]
                + actual12[3 * row + 2] * target12[3 * column + 2];
      }
    }
    // the rotation vector comes first: the way takes the place of what it is written into
    Rotations.matrixToVector(turn9, aside);
    for (int i = 0; i < 3; i++) {
      aside[3 + i] = aside[i];
      aside[i] = actual12[9 + i] - target12[9 + i];
    }
  }
}
