package org.pendant.recording.compare;

import java.util.Optional;
import org.pendant.controller.quantity.StateQuantity;

/**
 * Alignment: the shift in time that lays one run upon another: first by the start of motion, then
 * by the least squares of the joint speeds.
 */
final class Alignment {
  /** Rows that are looked at: more of them tell nothing new. */
  private static final int MAX_ROWS = 4000;

  private static final int MAX_COARSE_ROWS = 400;
  private static final int MAX_COARSE_STEPS = 20_000;
  private static final double COARSE_STEP_S = 0.02;

  /** How far the start of motion may mislead, s. */
  private static final double START_WINDOW_S = 0.3;

  private static final double FINE_S = 1e-5;
  private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

  private final Samples reference;
  private final Samples other;
  private final StateQuantity speed;

  private Alignment(Samples reference, Samples other, StateQuantity speed) {
    this.reference = reference;
    this.other = other;
    this.speed = speed;
  }

  /**
   * How much later, s, things happen in {@code other} by its own clock than in {@code reference}.
   *
   * @param speed of the joints, which both have
   */
  static double shiftS(Samples reference, Samples other, StateQuantity speed) {
    return new Alignment(reference, other, speed).best();
  }

  private double best() {
    double topRadPerS = MotionSpan.topRadPerS(reference, speed);
    MotionSpan span = new MotionSpan(reference, speed, topRadPerS);
    Optional<Double> mine = span.firstHalfS();
    Optional<Double> theirs = new MotionSpan(other, speed, topRadPerS).firstHalfS();
    double coarse =
        !span.beginsInMotion() && mine.isPresent() && theirs.isPresent()
            ? scan(
                theirs.get() - mine.get() - START_WINDOW_S,
                theirs.get() - mine.get() + START_WINDOW_S)
            : scan(other.firstS() - reference.lastS(), other.lastS() - reference.firstS());
    return descend(coarse - 2 * COARSE_STEP_S, coarse + 2 * COARSE_STEP_S);
  }

  private double scan(double fromS, double toS) {
    double step = Math.max(COARSE_STEP_S, (toS - fromS) / MAX_COARSE_STEPS);
    double best = fromS;
    double least = Double.POSITIVE_INFINITY;
    for (double shift = fromS; shift <= toS; shift += step) {
      double squares = squares(shift, MAX_COARSE_ROWS);
      if (squares < least) {
        least = squares;
        best = shift;
      }
    }
    return best;
  }

  /** Golden section (W. Press et al., "Numerical Recipes", section 10.2). */
  private double descend(double fromS, double toS) {
    double a = fromS;
    double b = toS;
    double c = b - GOLDEN * (b - a);
    double d = a + GOLDEN * (b - a);
    double atC = squares(c, MAX_ROWS);
    double atD = squares(d, MAX_ROWS);
    while (b - a > FINE_S) {
      if (atC < atD) {
        b = d;
        d = c;
        atD = atC;
        c = b - GOLDEN * (b - a);
        atC = squares(c, MAX_ROWS);
      } else {
        a = c;
        c = d;
        atC = atD;
        d = a + GOLDEN * (b - a);
        atD = squares(d, MAX_ROWS);
      }
    }
    return (a + b) / 2;
  }

  private double squares(double shiftS, int mostRows) {
    int step = Math.max(1, reference.rows() / mostRows);
    double sum = 0;
    for (int row = 0; row < reference.rows(); row += step) {
      double timeS = reference.timeS(row) + shiftS;
      for (int i = 0; i < speed.size(); i++) {
        double difference = reference.value(speed, i, row) - other.at(speed, i, timeS);
        sum += difference * difference;
      }
    }
    return sum;
  }
}
