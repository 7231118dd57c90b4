package org.pendant.controller.jog;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.motion.MotionControl;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Looks as far ahead as the arm needs to come to rest, for limits that it must not pass. */
final class Outlook {
  /** Time beyond that to come to rest, s: rounding, the curve of the path, a frame of delay. */
  private static final double RESERVE_S = 0.04;

  private final ControlBox box;

  Outlook(ControlBox box) {
    this.box = box;
  }

  /**
   * Why the arm must stop now; empty if it may go on. An arm that is beyond a limit already may
   * move: this is how it gets back.
   */
  Optional<String> obstacle(JogPlanner ranges) {
    Joints here = box.motion().positionRad();
    Joints speed = box.motion().speedRadPerS();
    double fastest = speed.maxAbsDifference(Joints.ZERO);
    if (fastest == 0) {
      return Optional.empty();
    }
    double seconds = fastest / (2 * MotionControl.SCALING_ACCELERATION_RAD_PER_S2) + RESERVE_S;
    Joints ahead = after(here, speed, seconds);
    for (int i = 0; i < Joints.COUNT; i++) {
      double step = ahead.get(i) - here.get(i);
      if ((step > 0 && ahead.get(i) > ranges.maxRad(i))
          || (step < 0 && ahead.get(i) < ranges.minRad(i))) {
        return Optional.of("joint " + i + " is at the end of its range");
      }
    }
    Pose tcp = box.tool().inFlange();
    return box.safety().within(ahead, tcp) || !box.safety().within(here, tcp)
        ? Optional.empty()
        : Optional.of("a safety plane, or the tilt that the tool may have, is reached");
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
