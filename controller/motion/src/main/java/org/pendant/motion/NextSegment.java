package org.pendant.motion;

import java.util.List;
import java.util.OptionalDouble;
import org.pendant.motion.profile.ProfileLimits;

/** Next segment: the part of the move after a corner that the speed in the corner depends on. */
final class NextSegment {
  /** Room for rounding in comparisons. */
  private static final double ROUNDING = 1 + 1e-6;

  private final MotionPath path;
  private final Move move;
  private final double nextLeft;
  private final List<Move> further;
  private final ProfileLimits limits;
  private OptionalDouble end = OptionalDouble.empty();

  /**
   * A move.
   *
   * @param nextLeft how far before its end it may be taken over in turn
   * @param further the moves after it, as far as is known
   */
  NextSegment(MotionPath path, Move move, double nextLeft, List<Move> further) {
    this.path = path;
    this.move = move;
    this.nextLeft = nextLeft;
    this.further = further;
    limits = move.limits(path, move.blendRadiusM() > 0 ? 0 : 1);
  }

  ProfileLimits limits() {
    return limits;
  }

  /** The rate that its own end may be reached at. */
  double end() throws PlanningException {
    if (end.isEmpty()) {
      double rate =
          move.blendRadiusM() > 0 ? Corner.entryRate(path, nextLeft, limits, move, further) : 0;
      end = OptionalDouble.of(Math.min(rate, limits.speed()));
    }
    return end.getAsDouble();
  }

  /** The highest rate, up to a limit, from which it can continue. */
  double fastestBegin(double entered, double most) throws PlanningException {
    double free = Math.max(0, path.length() - entered - nextLeft);
    double toRest = limits.fastestBegin(free, 0);
    // what comes later makes a difference only where it cannot even stop before that
    return toRest >= most ? most : Math.min(most, limits.fastestBegin(free, end()));
  }

  /**
   * How much sooner it comes as far when it does not begin at rest, s.
   *
   * @param entered where it begins instead
   * @param rate how fast there
   */
  double gainedS(double entered, double rate) throws PlanningException {
    double length = path.length();
    if (rate <= limits.fastestBegin(length - entered, 0) * ROUNDING) {
      return limits.between(length, 0, 0).durationS()
          - limits.between(length - entered, rate, 0).durationS();
    }
    double to = length - nextLeft;
    double fromRest = Math.min(end(), limits.fastestEnd(to, 0));
    double going = Math.min(end(), limits.fastestEnd(to - entered, rate));
    return limits.between(to, 0, fromRest).durationS()
        - limits.between(to - entered, rate, going).durationS();
  }
}
