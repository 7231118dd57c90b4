package org.pendant.desktop.scene;

import java.util.Optional;
import java.util.stream.IntStream;
import org.pendant.recording.lines.Margin;

/**
 * TCP trace: the path that the tool centre point took, in the base frame; immutable. A {@link
 * TraceRing} makes them.
 */
public final class TcpTrace {
  /** No way at all. */
  public static final TcpTrace EMPTY = new TcpTrace(new float[0], 0, 1, Optional.empty());

  /**
   * Numbers of a point: x, y, z, m, its speed, m/s, below 0 where a new line begins, and the line
   * of the program, the robot time, s, and how much of each margin was used, 0 to 1.
   */
  static final int STRIDE = 6 + Margin.values().length;

  /** Where the used parts of the margins begin among the numbers of a point. */
  static final int MARGINS = 6;

  /** The oldest points fade, so that none of them vanishes suddenly: this share of all. */
  private static final float FADING_SHARE = 0.35f;

  private static final double MIN_SCALE_M_PER_S = 0.01;

  /** A speed that is hardly above a step of the scale belongs to it. */
  private static final double ROUNDING = 0.98;

  private final float[] points;
  private final double scaleMPerS;
  private final int capacity;
  private final Optional<Margin> colouring;
  private final Optional<TcpTrace> elbow;

  /**
   * @param fastestMPerS speed of the fastest point, m/s
   * @param capacity after how many more points a point is forgotten
   * @param colouring the margin that it is coloured by; empty for the speed
   */
  TcpTrace(float[] points, double fastestMPerS, int capacity, Optional<Margin> colouring) {
    this.points = points;
    scaleMPerS = scaleMPerS(fastestMPerS);
    this.capacity = capacity;
    this.colouring = colouring;
    elbow = Optional.empty();
  }

  private TcpTrace(TcpTrace tool, double scaleMPerS, Optional<TcpTrace> elbow) {
    points = tool.points;
    capacity = tool.capacity;
    colouring = tool.colouring;
    this.scaleMPerS = scaleMPerS;
    this.elbow = elbow;
  }

  /** With the way of the elbow beside it; both have one scale of speeds. */
  public TcpTrace withElbow(TcpTrace way) {
    double scale = Math.max(scaleMPerS, way.scaleMPerS);
    return new TcpTrace(this, scale, Optional.of(new TcpTrace(way, scale, Optional.empty())));
  }

  /** The way of the elbow, if that is part of it. */
  public Optional<TcpTrace> elbow() {
    return elbow;
  }

  /** How many points there are. */
  public int size() {
    return points.length / STRIDE;
  }

  /** Position of point {@code i}, m. */
  public float x(int i) {
    return points[STRIDE * i];
  }

  /** Position of point {@code i}, m. */
  public float y(int i) {
    return points[STRIDE * i + 1];
  }

  /** Position of point {@code i}, m. */
  public float z(int i) {
    return points[STRIDE * i + 2];
  }

  /** Whether no line leads from the point before to point {@code i}. */
  public boolean begins(int i) {
    return i == 0 || points[STRIDE * i + 3] < 0;
  }

  /** Whether there is a line to be seen: single points are none. */
  public boolean hasLine() {
    return IntStream.range(0, size()).anyMatch(i -> !begins(i));
  }

  /** Speed on the way to point {@code i} as a share, 0 to 1, of {@link #scaleMPerS}. */
  public float speedShare(int i) {
    float speed = Math.max(points[STRIDE * i + 3], 0);
    return (float) (speed / scaleMPerS);
  }

  /** Speed on the way to point {@code i}, m/s. */
  public double speedMPerS(int i) {
    return Math.max(points[STRIDE * i + 3], 0);
  }

  /** The margin that it is coloured by; empty for the speed. */
  public Optional<Margin> colouring() {
    return colouring;
  }

  /** How much of the margin that it is coloured by was used at point {@code i}, 0 to 1. */
  public float used(int i) {
    return colouring.map(margin -> points[STRIDE * i + MARGINS + margin.index()]).orElse(0f);
  }

  /** The share that says the colour of point {@code i}, see {@link SpeedColours}. */
  public double colourShare(int i) {
    return colouring.isEmpty() ? speedShare(i) : (double) used(i) * used(i);
  }

  /** The line that the program had reached at point {@code i}; 0 without a program. */
  public int line(int i) {
    return (int) points[STRIDE * i + 4];
  }

  /** When the tool was at point {@code i}, robot time, s. */
  public double timeS(int i) {
    return points[STRIDE * i + 5];
  }

  /** How long the way around point {@code i} took that belongs to one line of the program, s. */
  public double stretchS(int i) {
    int first = i;
    while (!begins(first) && line(first - 1) == line(i)) {
      first--;
    }
    int last = i;
    while (last + 1 < size() && !begins(last + 1) && line(last + 1) == line(i)) {
      last++;
    }
    return timeS(last) - timeS(first);
  }

  /** How well point {@code i} is still seen: 1, or less, down to 0, as it is about to go. */
  public float opacity(int i) {
    int left = capacity - (size() - 1 - i);
    return Math.clamp(left / (FADING_SHARE * capacity), 0, 1);
  }

  /**
   * Speed that is drawn in the colour of the fastest, m/s: 1, 2, 4 or 8 of some power of ten, so
   * that colours keep their meaning while the trace grows.
   */
  public double scaleMPerS() {
    return scaleMPerS;
  }

  private static double scaleMPerS(double fastestMPerS) {
    double scale = MIN_SCALE_M_PER_S;
    for (int step = 0; scale < ROUNDING * fastestMPerS; step++) {
      // 1, 2, 4, 8, 10, 20 ...
      scale *= step % 4 == 3 ? 1.25 : 2;
    }
    return scale;
  }
}
