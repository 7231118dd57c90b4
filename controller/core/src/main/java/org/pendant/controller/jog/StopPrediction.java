package org.pendant.controller.jog;

import static org.pendant.controller.jog.JogTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.Singularity;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionControl;

/**
 * Stop prediction: where the arm would come to rest if it stopped now, for limits that it must not
 * pass.
 */
final class StopPrediction {
  /** How fast the arm stops, rad/s². */
  static final double STOP_RAD_PER_S2 = MotionControl.SCALING_ACCELERATION_RAD_PER_S2;

  /** Time beyond that to come to rest, s: rounding, the curve of the path, a frame of delay. */
  private static final double RESERVE_S = 0.04;

  /** How far the speed of a {@link Singularity#measure} is looked at, s. */
  private static final double STEP_S = 1e-4;

  /** Below this measure the arm is in the singularity, and may move as long as it stays there. */
  private static final double IN_IT = 1e-6;

  private final ControlBox box;

  StopPrediction(ControlBox box) {
    this.box = box;
  }

  /**
   * Why the arm must stop now; empty if it may continue. An arm that is beyond a limit already may
   * move: this is how it gets back.
   *
   * @param straight whether the tool keeps to a path, which cannot lead through a singularity
   */
  Optional<String> obstacle(JogPlanner ranges, boolean straight) {
    Joints here = box.motion().positionRad();
    Joints speed = box.motion().speedRadPerS();
    double fastest = speed.maxAbsDifference(Joints.ZERO);
    if (fastest == 0) {
      return Optional.empty();
    }
    Optional<String> singularity =
        straight ? singularity(here, speed, lookaheadS(fastest)) : Optional.empty();
    if (singularity.isPresent()) {
      return singularity;
    }
    Joints ahead = after(here, speed, lookaheadS(fastest));
    for (int i = 0; i < Joints.COUNT; i++) {
      double step = ahead.get(i) - here.get(i);
      if ((step > 0 && ahead.get(i) > ranges.maxRad(i))
          || (step < 0 && ahead.get(i) < ranges.minRad(i))) {
        return Optional.of(text("jointAtEnd", i));
      }
    }
    Pose tcp = box.flange().tool().inFlange();
    return box.safety().within(ahead, tcp) || !box.safety().within(here, tcp)
        ? Optional.empty()
        : Optional.of(text("safetyLimitReached"));
  }

  /** Time at the present speed that leads as far as the arm continues when it stops now, s. */
  private static double lookaheadS(double fastestRadPerS) {
    return fastestRadPerS / (2 * STOP_RAD_PER_S2) + RESERVE_S;
  }

  private Optional<String> singularity(Joints here, Joints speed, double withinS) {
    DhLengths dh = box.arm().description().dh();
    Joints next = after(here, speed, STEP_S);
    for (Singularity each : Singularity.values()) {
      double now = each.measure(dh, here);
      double perS = (each.measure(dh, next) - now) / STEP_S;
      if (now > IN_IT && now + perS * withinS < 0) {
        return Optional.of(
            switch (each) {
              case SHOULDER -> text("shoulderSingularity");
              case ELBOW -> text("elbowSingularity");
              case WRIST -> text("wristSingularity");
            });
      }
    }
    return Optional.empty();
  }

  private static Joints after(Joints here, Joints speed, double seconds) {
    return new Joints(
        here.q0() + seconds * speed.q0(),
        here.q1() + seconds * speed.q1(),
        here.q2() + seconds * speed.q2(),
        here.q3() + seconds * speed.q3(),
        here.q4() + seconds * speed.q4(),
        here.q5() + seconds * speed.q5());
  }
}
