package org.pendant.motion.toolpath;

import java.util.Arrays;

/**
 * Speed law: the fastest time law along a chain from rest to rest with even accelerations: each
 * piece within its own speed and acceleration, each junction no faster than the pieces after it
 * allow the tool to slow down from. Two passes over the junctions find their speeds, backwards for
 * braking and forwards for speeding up.
 */
final class SpeedLaw {
  private final int phases;
  private final double[] beginS;
  private final double[] position;
  private final double[] speed;
  private final double[] acceleration;
  private final double durationS;
  private final double length;
  private int current;

  SpeedLaw(Chain chain) {
    Phases made = new Phases(3 * chain.pieces().size());
    double[] junctions = junctions(chain);
    for (int i = 0; i < chain.pieces().size(); i++) {
      Chain.Piece piece = chain.pieces().get(i);
      made.position = chain.begin(i);
      made.pass(piece, junctions[i], junctions[i + 1]);
    }
    phases = made.count;
    beginS = Arrays.copyOf(made.beginS, phases);
    position = Arrays.copyOf(made.positions, phases);
    speed = Arrays.copyOf(made.speeds, phases);
    acceleration = Arrays.copyOf(made.accelerations, phases);
    durationS = made.timeS;
    length = chain.length();
  }

  private static double[] junctions(Chain chain) {
    int n = chain.pieces().size();
    double[] speeds = new double[n + 1];
    for (int i = n - 1; i > 0; i--) {
      Chain.Piece before = chain.pieces().get(i - 1);
      Chain.Piece piece = chain.pieces().get(i);
      double cap = before.stops() ? 0 : Math.min(before.speed(), piece.speed());
      speeds[i] = Math.min(cap, reached(speeds[i + 1], piece));
    }
    for (int i = 1; i < n; i++) {
      speeds[i] = Math.min(speeds[i], reached(speeds[i - 1], chain.pieces().get(i - 1)));
    }
    return speeds;
  }

  private static double reached(double from, Chain.Piece piece) {
    return Math.sqrt(from * from + 2 * piece.acceleration() * piece.length());
  }

  /** Phases of even acceleration as they are found. */
  private static final class Phases {
    private final double[] beginS;
    private final double[] positions;
    private final double[] speeds;
    private final double[] accelerations;
    private int count;
    private double timeS;
    private double position;

    Phases(int most) {
      beginS = new double[most];
      positions = new double[most];
      speeds = new double[most];
      accelerations = new double[most];
    }

    void pass(Chain.Piece piece, double from, double to) {
      double a = piece.acceleration();
      double top =
          Math.min(piece.speed(), Math.sqrt(a * piece.length() + 0.5 * (from * from + to * to)));
      double peak = Math.max(top, Math.max(from, to));
      double up = 0.5 * (peak * peak - from * from) / a;
      double down = 0.5 * (peak * peak - to * to) / a;
      phase((peak - from) / a, from, a);
      phase(Math.max(0, piece.length() - up - down) / peak, peak, 0);
      phase((peak - to) / a, peak, -a);
    }

    private void phase(double lastsS, double begin, double a) {
      if (lastsS > 0) {
        beginS[count] = timeS;
        positions[count] = position;
        speeds[count] = begin;
        accelerations[count] = a;
        count++;
        timeS += lastsS;
        position += lastsS * (begin + 0.5 * a * lastsS);
      }
    }
  }

  double durationS() {
    return durationS;
  }

  /** Where on the chain at a time. */
  double position(double timeS) {
    int i = find(timeS);
    double t = timeS - beginS[i];
    return timeS >= durationS
        ? length
        : Math.min(length, position[i] + t * (speed[i] + 0.5 * acceleration[i] * t));
  }

  /** How fast, per s; 0 at the end. */
  double speed(double timeS) {
    int i = find(timeS);
    return timeS >= durationS ? 0 : Math.max(0, speed[i] + acceleration[i] * (timeS - beginS[i]));
  }

  /** How the speed changes, per s²; 0 at both ends. */
  double acceleration(double timeS) {
    return timeS <= 0 || timeS >= durationS ? 0 : acceleration[find(timeS)];
  }

  /** The phase at a time, looked for from the last one on. */
  private int find(double timeS) {
    while (current + 1 < phases && timeS >= beginS[current + 1]) {
      current++;
    }
    while (current > 0 && timeS < beginS[current]) {
      current--;
    }
    return current;
  }
}
