package org.pendant.motion.servo;

import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.models.pose.Pose;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionSample;
import org.pendant.motion.ToolPathFollower;

/** Tool speed motion: the velocity of the TCP changes evenly to a constant one (manual 15.49). */
final class SpeedL implements Motion {
  private final ToolPathFollower follower;
  private final double returnS;
  private final boolean timed;
  private final Optional<MotionPlan> ending;

  /**
   * A motion on a curve whose parameter is time.
   *
   * @param rampS how long the velocity changes, s
   * @param returnS when the program continues, s; empty for when the velocity is reached
   * @param ending when nothing follows then
   */
  SpeedL(ToolPathFollower follower, double rampS, OptionalDouble returnS, MotionPlan ending) {
    this.follower = follower;
    this.returnS = returnS.orElse(rampS);
    timed = returnS.isPresent();
    this.ending = Optional.of(ending);
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
    return "speedl";
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    return follower.sample(timeS, 1, 0, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.empty();
  }
}
