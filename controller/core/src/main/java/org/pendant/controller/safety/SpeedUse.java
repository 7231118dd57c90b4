package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Speed use: how much of one of the limits that slow motions down ({@link SpeedCaps}) a state of
 * the arm takes.
 *
 * @param joint 0 to 5; that of the fastest joint for limits that are not of one joint
 * @param value in rad/s, m/s, kg m/s, s or m
 * @param slowedAt the value at which motions are slowed down, a little below the limit itself
 * @param share of {@code slowedAt} as the speed of the motion counts: 1 where motions are slowed
 *     down
 */
public record SpeedUse(Kind kind, int joint, double value, double slowedAt, double share) {
  /** Which limit. */
  public enum Kind {
    JOINT_SPEED("jointSpeed"),
    TOOL_SPEED("toolSpeed"),
    ELBOW_SPEED("elbowSpeed"),
    MOMENTUM("momentum"),
    STOPPING_TIME("stoppingTime"),
    STOPPING_DISTANCE("stoppingDistance");

    private final String key;

    Kind(String key) {
      this.key = key;
    }

    /** Its name in a sentence. */
    public String words() {
      return text(key);
    }
  }

  /**
   * Those of a state, the nearest to its limit first.
   *
   * @param qRad joint positions of the target
   * @param qdRadPerS joint speeds of the target
   * @param momentumKgMPerS of arm and payload
   * @param limits that hold; on the way from one set to another both count in part, which this does
   *     not know
   */
  public static List<SpeedUse> of(
      ArmDescription arm,
      Joints qRad,
      Joints qdRadPerS,
      Pose tcpInFlange,
      double momentumKgMPerS,
      SafetyLimits limits) {
    double[] qd = qdRadPerS.toArray();
    ArmPoints points = new ArmPoints(arm);
    points.at(qRad.toArray(), qd, tcpInFlange);
    List<SpeedUse> uses = new ArrayList<>();
    int fastest = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double most =
          Math.min(
              SpeedCaps.SHARE * limits.jointSpeedRadPerS().get(i),
              arm.joints().get(i).maxSpeedRadPerS());
      uses.add(use(Kind.JOINT_SPEED, i, Math.abs(qd[i]), most));
      fastest = Math.abs(qd[i]) > Math.abs(qd[fastest]) ? i : fastest;
    }
    double toolSpeed = points.toolSpeedMPerS();
    double stopS = Stopping.timeS(qd);
    uses.add(use(Kind.TOOL_SPEED, fastest, toolSpeed, cap(limits.toolSpeedMPerS())));
    uses.add(
        use(Kind.ELBOW_SPEED, fastest, points.elbowSpeedMPerS(), cap(limits.elbowSpeedMPerS())));
    uses.add(use(Kind.MOMENTUM, fastest, momentumKgMPerS, cap(limits.momentumKgMPerS())));
    uses.add(use(Kind.STOPPING_TIME, fastest, stopS, cap(limits.stoppingTimeS())));
    double travelM = toolSpeed * stopS / 2;
    double farthestM = cap(limits.stoppingDistanceM());
    uses.add(
        // both the speed and the time to stop shrink with the scaling
        new SpeedUse(
            Kind.STOPPING_DISTANCE, fastest, travelM, farthestM, Math.sqrt(travelM / farthestM)));
    uses.sort(Comparator.comparingDouble(SpeedUse::share).reversed());
    return List.copyOf(uses);
  }

  private static double cap(double limit) {
    return SpeedCaps.SHARE * limit;
  }

  private static SpeedUse use(Kind kind, int joint, double value, double slowedAt) {
    return new SpeedUse(kind, joint, value, slowedAt, value / slowedAt);
  }
}
