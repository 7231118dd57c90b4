package org.pendant.motion.toolpath;

import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Singularity;
import org.pendant.models.pose.Transforms;

/**
 * Free tool rotation: chooses how a tool that is free to turn about its z-axis does so along a
 * chain (manual 20.6, doc 5): from point to point so that the joints move little and stay away from
 * their limits and from singularities. In the limit of many points this is the gradient flow on the
 * null space of the five constrained directions. (B. Siciliano et al., "Robotics: Modelling,
 * Planning and Control", Springer 2009, section 3.5.1.)
 */
final class FreeTurn {
  private static final int MAX_POINTS = 2000;
  private static final double DISTANCE_M = 0.004;

  /** The fastest turn, rad for each metre. */
  private static final double MAX_RAD_PER_M = 40;

  /** Points looked at on a step, and how often the search narrows down around the best. */
  private static final int LOOKS = 4;

  private static final int NARROWINGS = 5;

  /** How much comfort counts against joint motion, rad²/m. */
  private static final double COMFORT = 4;

  /** How far from a singularity (0 to 1) and from a limit (rad) nothing is uncomfortable. */
  private static final double SINGULAR_ROOM = 0.35;

  private static final double LIMIT_ROOM_RAD = 0.6;

  private final ArmDescription arm;
  private final Chain chain;
  private final ToolConfiguration.Mapping mapping;
  private final InverseKinematics inverse;
  private final double[] work = new double[Transforms.SIZE];
  private final double[] spun = new double[Transforms.SIZE];
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] tried = new double[Joints.COUNT];

  private FreeTurn(ArmDescription arm, Chain chain, ToolConfiguration toolConfiguration) {
    this.arm = arm;
    this.chain = chain;
    mapping = toolConfiguration.mapping();
    inverse = new InverseKinematics(arm);
  }

  /**
   * The angle along a chain, 0 at its start.
   *
   * @param from joint positions there, rad
   */
  static Spline along(
      ArmDescription arm, Chain chain, ToolConfiguration toolConfiguration, Joints from) {
    return new FreeTurn(arm, chain, toolConfiguration).angles(from.toArray());
  }

  private Spline angles(double[] q) {
    double length = chain.length();
    int steps = (int) Math.max(4, Math.min(MAX_POINTS, Math.ceil(length / DISTANCE_M)));
    double step = length / steps;
    double[] angles = new double[steps + 1];
    for (int i = 1; i <= steps; i++) {
      chain.at(i * step, work);
      angles[i] = next(q, angles[i - 1], step);
      if (discomfort(q, angles[i]) < Double.POSITIVE_INFINITY) {
        System.arraycopy(tried, 0, q, 0, Joints.COUNT);
      }
    }
    return new Spline(angles, step);
  }

  private double next(double[] q, double angle, double step) {
    double best = angle;
    double least = cost(q, angle, step);
    double width = MAX_RAD_PER_M * step / LOOKS;
    for (int narrowing = 0; narrowing < NARROWINGS; narrowing++) {
      double middle = best;
      for (int i = -LOOKS; i <= LOOKS; i++) {
        double candidate = middle + i * width;
        boolean slow = Math.abs(candidate - angle) <= MAX_RAD_PER_M * step * (1 + 1e-9);
        double cost = slow && i != 0 ? cost(q, candidate, step) : Double.POSITIVE_INFINITY;
        if (cost < least) {
          least = cost;
          best = candidate;
        }
      }
      width /= LOOKS;
    }
    return best;
  }

  private double cost(double[] q, double angle, double step) {
    double discomfort = discomfort(q, angle);
    double moved = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      moved += (tried[i] - q[i]) * (tried[i] - q[i]);
    }
    return moved / (2 * step) + COMFORT * discomfort;
  }

  /** How near joints are to limits and singularities; infinite where nothing reaches. */
  private double discomfort(double[] q, double angle) {
    System.arraycopy(work, 0, spun, 0, Transforms.SIZE);
    RotatedSegment.spin(spun, angle);
    mapping.flange(spun, flange);
    System.arraycopy(q, 0, tried, 0, Joints.COUNT);
    if (!inverse.track(flange, tried)) {
      return Double.POSITIVE_INFINITY;
    }
    double sum = 0;
    Joints joints = Joints.of(tried);
    for (Singularity each : Singularity.values()) {
      sum += lack(each.measure(arm.dh(), joints), SINGULAR_ROOM);
    }
    List<JointLimits> limits = arm.joints();
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits limit = limits.get(i);
      sum +=
          lack(
              Math.min(tried[i] - limit.lowestRad(), limit.highestRad() - tried[i]),
              LIMIT_ROOM_RAD);
    }
    return sum;
  }

  private static double lack(double room, double enough) {
    double part = Math.max(0, 1 - room / enough);
    return part * part;
  }
}
