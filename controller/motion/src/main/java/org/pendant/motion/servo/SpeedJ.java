package org.pendant.motion.servo;

import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionSample;
import org.pendant.motion.StopJ;

/**
 * Joint speed motion: all joint speeds change evenly to constant ones and arrive at the same moment
 * (manual 15.48).
 */
final class SpeedJ implements Motion {
  private final Joints from;
  private final Joints begin;
  private final Joints end;
  private final double rampS;
  private final double returnS;
  private final boolean timed;
  private final Optional<MotionPlan> ending;

  SpeedJ(
      Joints from, Joints begin, Joints end, double accelerationRadPerS2, OptionalDouble returnS) {
    this.from = from;
    this.begin = begin;
    this.end = end;
    rampS = begin.maxAbsDifference(end) / accelerationRadPerS2;
    this.returnS = returnS.orElse(rampS);
    timed = returnS.isPresent();
    ending = Optional.of((q, qd) -> new StopJ(q, qd, accelerationRadPerS2));
  }

  @Override
  public double durationS() {
    return Servoing.ENDLESS_S;
  }

  @Override
  public double handOverS() {
    return returnS;
  }

  @Override
  public boolean timed() {
    return timed;
  }

  @Override
  public Optional<MotionPlan> ending() {
    return ending;
  }

  @Override
  public String driver() {
    return "speedj";
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    double share = timeS < rampS ? timeS / rampS : 1;
    // the change counts for half of the ramp and for all of the time after it
    double changedS = timeS < rampS ? 0.5 * share * timeS : timeS - 0.5 * rampS;
    double perS = timeS <= rampS && rampS > 0 ? 1 / rampS : 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double v = begin.get(i);
      double change = end.get(i) - v;
      double speed = share == 1 ? end.get(i) : v + share * change;
      sample.set(i, from.get(i) + v * timeS + change * changedS, speed, change * perS);
    }
    return Optional.empty();
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.empty();
  }
}
