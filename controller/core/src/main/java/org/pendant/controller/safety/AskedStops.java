package org.pendant.controller.safety;

import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.world.LinkHit;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.force.TaskDeviation;

/**
 * Requested stops: protective stops that other parts of the controller have asked for since the
 * last frame.
 */
final class AskedStops {
  private boolean program;
  private Optional<MotionFailure> lostPath = Optional.empty();
  private OptionalDouble wrongPayloadN = OptionalDouble.empty();
  private double payloadToleranceN;
  private Optional<TaskDeviation> aside = Optional.empty();
  private Optional<LinkHit> linkHit = Optional.empty();

  void ofProgram() {
    program = true;
  }

  void lostPath(MotionFailure why) {
    lostPath = Optional.of(why);
  }

  void wrongPayload(double forceN, double toleranceN) {
    wrongPayloadN = OptionalDouble.of(forceN);
    payloadToleranceN = toleranceN;
  }

  void aside(TaskDeviation deviation) {
    aside = Optional.of(deviation);
  }

  void linkHit(LinkHit hit) {
    linkHit = Optional.of(hit);
  }

  void forget() {
    program = false;
    lostPath = Optional.empty();
    wrongPayloadN = OptionalDouble.empty();
    aside = Optional.empty();
    linkHit = Optional.empty();
  }

  /** The stop that counts of those that are asked for. */
  Optional<SafetyStop> first(FrameFacts facts, Observation seen, SafetyLimits limits) {
    if (program) {
      return Optional.of(StopReason.PROGRAM.asked(facts.timeS()));
    }
    if (lostPath.isPresent()) {
      return Optional.of(LostPath.stop(lostPath.get(), seen.targetQ, limits, facts.timeS()));
    }
    if (wrongPayloadN.isPresent()) {
      return Optional.of(
          StopReason.WRONG_PAYLOAD.of(
              facts.timeS(), wrongPayloadN.getAsDouble(), payloadToleranceN));
    }
    if (linkHit.isPresent()) {
      LinkHit hit = linkHit.get();
      return Optional.of(
          StopReason.LINK_HIT.ofLink(hit.sentence(), hit.joint(), facts.timeS(), hit.depthM()));
    }
    // no lambda: this is asked in every frame
    return aside.isPresent()
        ? Optional.of(aside(aside.get(), farthestJoint(seen), facts.timeS()))
        : Optional.empty();
  }

  /** The joint that is farthest from its target. */
  private static int farthestJoint(Observation seen) {
    int farthest = 0;
    for (int i = 1; i < seen.q.length; i++) {
      if (Math.abs(seen.targetQ[i] - seen.q[i])
          > Math.abs(seen.targetQ[farthest] - seen.q[farthest])) {
        farthest = i;
      }
    }
    return farthest;
  }

  /** The stop on account of joint {@code joint} (0 to 5), which is farthest off. */
  private static SafetyStop aside(TaskDeviation deviation, int joint, double timeS) {
    StopReason reason =
        deviation.turned() ? StopReason.FORCE_MODE_TURN : StopReason.FORCE_MODE_SHIFT;
    return reason.alongAxis(
        deviation.axisName(), joint, timeS, deviation.amount(), deviation.limit());
  }
}
