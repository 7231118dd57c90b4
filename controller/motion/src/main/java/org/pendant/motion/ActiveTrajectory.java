package org.pendant.motion;

import static org.pendant.motion.MotionTexts.text;

import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.text.FloatText;
import org.pendant.models.time.FrameTime;

/**
 * Active trajectory: the motion under way, the time along it, and its time scaling. Motion time is
 * counted in frames, and a motion at full speed is evaluated at whole ones: it is never integrated.
 */
final class ActiveTrajectory {
  /** The slowest that time on a path may run; a path that needs it slower cannot be followed. */
  static final double MIN_SCALING = 0.02;

  /** Whatever limits ramps, none slows down for longer; then it ends as if it were not limited. */
  private static final int MAX_LIMITED_RAMP_FRAMES = FrameTime.FRAMES_PER_SECOND;

  private final PathLimiter limiter;
  private final JointSpeedCheck jointSpeeds;
  private final MotionSample sample = new MotionSample();
  private final MotionSample last = new MotionSample();
  private final double[] previous = new double[Joints.COUNT];
  private final TimeScaling time = new TimeScaling();
  private RampLimiter ramps = RampLimiter.NONE;
  private Optional<Motion> active = Optional.empty();
  private double frames;

  /** How much of {@link #frames} the last frame added. */
  private double step;

  /** What the motion before took of the time of this one, in frames. */
  private double spent;

  /** How long the scaling has been falling. */
  private int slowingFrames;

  /**
   * No motion.
   *
   * @param limiter slows motions down where they would exceed what it knows
   */
  ActiveTrajectory(PathLimiter limiter, JointSpeedCheck jointSpeeds) {
    this.limiter = limiter;
    this.jointSpeeds = jointSpeeds;
  }

  /** How fast the scaling may change is limited by this from now on. */
  void limitRamps(RampLimiter limiter) {
    ramps = limiter;
  }

  /** The motion, if there is one. */
  Optional<Motion> active() {
    return active;
  }

  /** Whether there is a motion. */
  boolean present() {
    return active.isPresent();
  }

  /** The motion that there is. */
  Motion motion() {
    return active.orElseThrow();
  }

  /** How its time runs, and that of the next one. */
  TimeScaling time() {
    return time;
  }

  /** How far the motion is, s in its own time. */
  double atS() {
    return frames * FrameTime.FRAME_S;
  }

  /** Whether the motion has not moved yet. */
  boolean unmoved() {
    return frames == 0;
  }

  /** Puts another motion in the place of whatever there is; how its time runs is left as it is. */
  void begin(Motion motion) {
    active = Optional.of(motion);
    time.setFactor(motion.speedFactor());
    frames = 0;
    spent = 0;
  }

  /**
   * The part of the last frame after the hand-over of a motion that was to last a time, in frames
   * of its own; 0 where all of the frame is, since every motion lasts one at least.
   */
  double overrun() {
    if (!motion().timed()) {
      return 0;
    }
    double over = frames + spent - motion().handOverS() / FrameTime.FRAME_S;
    return over < step - FrameTime.ROUNDING ? over : 0;
  }

  /** A motion that is to last a time has lasted {@code overrun} frames of it when it begins. */
  void takeOff(double overrun) {
    spent = motion().timed() ? overrun : 0;
  }

  /** The motion planned anew, or none any more. */
  void replace(Optional<Motion> anew) {
    active = anew;
  }

  /** The motion continues at speeds in its own time, before it has been sampled; rad/s. */
  void continueAt(Joints ownSpeedRadPerS, double scaling) {
    ownSpeedRadPerS.copyTo(sample.speed);
    time.continueAt(scaling);
  }

  /** There is no motion any more. */
  void forget() {
    active = Optional.empty();
    sample.rest();
    time.setFactor(1);
    time.begin(false);
  }

  /**
   * Goes a frame on.
   *
   * @param path where the motion was, overwritten by where it is unless it cannot go there
   * @return why it cannot
   */
  Optional<MotionFailure> advance(PathState path) {
    Motion motion = motion();
    double scalingBefore = time.scaling();
    double before = time.rateBefore();
    double framesBefore = frames;
    time.setFactor(motion.speedFactor());
    time.step(sample.fastestRadPerS());
    System.arraycopy(path.position().numbers(), 0, previous, 0, Joints.COUNT);
    last.copy(sample);
    Optional<MotionFailure> failure = sampleAfter(motion, framesBefore, scalingBefore);
    if (failure.isEmpty() && limitRamp(scalingBefore, before)) {
      failure = sampleAfter(motion, framesBefore, scalingBefore);
    }
    if (failure.isEmpty() && !time.stopping() && time.scaling() > 0) {
      double largest = sample.largestScaling(limiter);
      if (!(largest >= MIN_SCALING)) {
        failure = Optional.of(jointSpeeds.singular(sample));
      } else if (largest < time.rate()) {
        time.limitRateTo(largest);
        failure = sampleAfter(motion, framesBefore, scalingBefore);
      }
    }
    if (failure.isEmpty()) {
      failure = jointSpeeds.onPath(previous, sample, time.rate());
    }
    if (failure.isEmpty()) {
      path.follow(sample, time.rate(), (time.rate() - before) / FrameTime.FRAME_S);
      return failure;
    }
    return Optional.of(onTheWay(failure.get(), motion));
  }

  /** Changes the rate of time less than wanted where a limit demands that; whether it did. */
  private boolean limitRamp(double scalingBefore, double before) {
    double wanted = time.rate();
    slowingFrames = time.scaling() < scalingBefore ? slowingFrames + 1 : 0;
    if (wanted == before || time.stopping() || slowingFrames > MAX_LIMITED_RAMP_FRAMES) {
      return false;
    }
    double reachable = ramps.reachableScaling(last, sample, before, wanted);
    if (reachable != wanted) {
      time.changeRateTo(reachable);
    }
    return reachable != wanted;
  }

  /**
   * Samples the motion a frame further, its time running evenly from one scaling to the next, and
   * as fast as the start of the program has it when the frame begins.
   */
  private Optional<MotionFailure> sampleAfter(
      Motion motion, double framesBefore, double scalingBefore) {
    step = 0.5 * (scalingBefore + time.scaling()) * time.startBefore();
    frames = framesBefore + step;
    double timeS = atEnd(motion) ? motion.durationS() : frames * FrameTime.FRAME_S;
    sample.forgetFrames();
    return motion.sample(timeS, sample);
  }

  private boolean atEnd(Motion motion) {
    return frames >= motion.durationS() / FrameTime.FRAME_S - FrameTime.ROUNDING;
  }

  private static MotionFailure onTheWay(MotionFailure failure, Motion motion) {
    return motion
        .waypoint()
        .map(
            goal ->
                new MotionFailure(
                    failure.code(), text("onTheWay", failure.message(), FloatText.of(goal))))
        .orElse(failure);
  }

  /** Whether the motion is at its end, or has come to rest for good. */
  boolean ended() {
    return atEnd(motion()) || (time.scaling() == 0 && time.releasing());
  }

  /**
   * Whether the caller that waits for the motion continues now, to say what comes next: a frame
   * before a move may be left for another, or when a motion without an end has lasted as long as it
   * was asked to.
   */
  boolean handOverDue() {
    Motion motion = motion();
    if (!(motion.handOverS() < motion.durationS()) || time.releasing()) {
      return false;
    }
    double atFrame = motion.handOverS() / FrameTime.FRAME_S - FrameTime.ROUNDING;
    return motion.leaving().isPresent() ? frames + 1 > atFrame : frames + spent >= atFrame;
  }

  /** Whether a motion that slows down from now on comes to rest after its hand-over. */
  boolean handsOverBeforeRest() {
    if (time.scaling() == 0) {
      return false;
    }
    double rampS = 2 * time.untilRestS(sample.fastestRadPerS());
    return atS() + rampS + 2 * FrameTime.FRAME_S >= motion().handOverS();
  }

  /** The motion as it is when its waypoint does not matter any more; see {@link Motion}. */
  Optional<Motion> cutShort() {
    return motion().cutShort(atS());
  }
}
