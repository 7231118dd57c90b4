package org.pendant.desktop.scene;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.pose.Pose;
import org.pendant.recording.lines.FrameMargins;
import org.pendant.recording.lines.Margin;

/**
 * Trace ring: remembers the last points that the tool centre point passed; the oldest are
 * forgotten. Belongs to one thread.
 */
public final class TraceRing {
  /** Points nearer to the one before are left out, m. */
  private static final double SPACING_M = 1e-3;

  private static final List<Margin> MARGINS = List.of(Margin.values());

  private final float[] ring;
  private final int capacity;
  private long count;
  private double lastX;
  private double lastY;
  private double lastZ;
  private double lastS = Double.NaN;
  private Pose tool = Pose.ZERO;
  private Optional<Margin> colouring = Optional.empty();
  private Optional<TcpTrace> snapshot = Optional.of(TcpTrace.EMPTY);

  /**
   * @param capacity points that are remembered, at least 2
   */
  public TraceRing(int capacity) {
    if (capacity < 2) {
      throw new IllegalArgumentException("trace: capacity is " + capacity + ", must be at least 2");
    }
    this.capacity = capacity;
    ring = new float[TcpTrace.STRIDE * capacity];
  }

  /**
   * Adds where the tool centre point is at a robot time, s, if it has moved.
   *
   * @param line that the program has reached; 0 without a program
   */
  public void add(ArmState arm, double timeS, int line) {
    add(arm.actualTcpInBase(), arm.tool().inFlange(), timeS, line);
  }

  /** Adds where the tool centre point is, if it has moved, and how near the arm is to limits. */
  public void add(ControllerState state, FrameMargins margins) {
    long before = count;
    add(state.arm(), state.timeS(), state.program().line());
    note(margins, before);
  }

  /** As {@link #add(ControllerState, FrameMargins)}, for another point of the arm. */
  void add(Pose pointInBase, ControllerState state, FrameMargins margins) {
    long before = count;
    add(pointInBase, Pose.ZERO, state.timeS(), state.program().line());
    note(margins, before);
  }

  /** Adds to the last point how near the arm was to limits, if the point is a new one. */
  private void note(FrameMargins margins, long before) {
    if (count > before) {
      int at = (int) (before % capacity) * TcpTrace.STRIDE + TcpTrace.MARGINS;
      for (Margin each : MARGINS) {
        ring[at + each.index()] = (float) each.used(margins.value(each));
      }
    }
  }

  /** Has traces coloured by a margin; empty for the speed. */
  public void colourBy(Optional<Margin> margin) {
    if (!margin.equals(colouring)) {
      colouring = margin;
      snapshot = Optional.empty();
    }
  }

  /**
   * Adds a point. One of another tool begins a new line: nothing has moved there.
   *
   * @param timeS robot time, s
   */
  void add(Pose tcpInBase, Pose tcpInFlange, double timeS, int line) {
    double stepM =
        Math.sqrt(
            square(tcpInBase.x() - lastX)
                + square(tcpInBase.y() - lastY)
                + square(tcpInBase.z() - lastZ));
    boolean begins = Double.isNaN(lastS) || timeS < lastS || !tool.equals(tcpInFlange);
    if (!begins && (stepM < SPACING_M || timeS == lastS)) {
      return;
    }
    double elapsedS = timeS - lastS;
    int at = (int) (count % capacity) * TcpTrace.STRIDE;
    ring[at] = (float) tcpInBase.x();
    ring[at + 1] = (float) tcpInBase.y();
    ring[at + 2] = (float) tcpInBase.z();
    ring[at + 3] = begins ? -1 : (float) (stepM / elapsedS);
    ring[at + 4] = line;
    ring[at + 5] = (float) timeS;
    count++;
    lastX = tcpInBase.x();
    lastY = tcpInBase.y();
    lastZ = tcpInBase.z();
    lastS = timeS;
    tool = tcpInFlange;
    snapshot = Optional.empty();
  }

  /** Forgets everything. */
  public void clear() {
    count = 0;
    lastS = Double.NaN;
    snapshot = Optional.of(TcpTrace.EMPTY);
  }

  /** What is remembered, oldest first; the same object until something is added. */
  public TcpTrace trace() {
    if (snapshot.isEmpty()) {
      snapshot = Optional.of(copy());
    }
    return snapshot.get();
  }

  private TcpTrace copy() {
    int size = (int) Math.min(count, capacity);
    float[] points = new float[TcpTrace.STRIDE * size];
    double fastest = 0;
    for (int i = 0; i < size; i++) {
      int from = (int) ((count - size + i) % capacity) * TcpTrace.STRIDE;
      System.arraycopy(ring, from, points, TcpTrace.STRIDE * i, TcpTrace.STRIDE);
      fastest = Math.max(fastest, points[TcpTrace.STRIDE * i + 3]);
    }
    return new TcpTrace(points, fastest, capacity, colouring);
  }

  private static double square(double x) {
    return x * x;
  }
}
