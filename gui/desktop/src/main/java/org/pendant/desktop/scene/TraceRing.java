package org.pendant.desktop.scene;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.pose.Pose;
import org.pendant.recording.lines.FrameMargins;
import org.pendant.recording.lines.Margin;

/**
 * Trace ring: remembers the last points that the tool centre point, or another point of the arm,
 * passed; the oldest are forgotten. Belongs to one thread.
 *
 * <p>Of the places of all frames it keeps those that the line needs: while the arm moves straight
 * on, the newest point moves with it, so that corners and curves are drawn as they were however
 * many frames there are.
 */
public final class TraceRing {
  /** No place that is left out was farther from the line, m. */
  private static final double TOLERANCE_M = 2e-4;

  /** Nearer to the one before, a place is noise or says nothing new, m. */
  private static final double STILL_M = 3e-4;

  /** Points of a line, which are not farther apart in time, s, unless they are so near. */
  private static final double MAX_STEP_S = 0.05;

  private static final double SPACING_M = 1e-3;

  /**
   * More places between two points than there can be: frames of a step in time, or of a spacing.
   */
  private static final int MAX_PASSED = 32;

  private static final List<Margin> MARGINS = List.of(Margin.values());

  private final float[] ring;
  private final int capacity;
  private final double[] passed = new double[3 * MAX_PASSED];
  private int passedCount;
  private long count;

  /** The point before the newest one, from which the line leads to it. */
  private double fromX;

  private double fromY;
  private double fromZ;
  private double fromS;
  private double lastX;
  private double lastY;
  private double lastZ;
  private double lastS = Double.NaN;

  /** Whether no line leads to the newest point. */
  private boolean begun;

  private int line;
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
   * @return whether it has moved
   */
  public boolean add(ArmState arm, double timeS, int line) {
    return add(arm.actualTcpInBase(), arm.tool().inFlange(), timeS, line);
  }

  /** Adds where the tool centre point is, if it has moved, and how near the arm is to limits. */
  public void add(ControllerState state, FrameMargins margins) {
    if (add(state.arm(), state.timeS(), state.program().line())) {
      note(margins);
    }
  }

  /** As {@link #add(ControllerState, FrameMargins)}, for another point of the arm. */
  void add(Pose pointInBase, ControllerState state, FrameMargins margins) {
    if (add(pointInBase, Pose.ZERO, state.timeS(), state.program().line())) {
      note(margins);
    }
  }

  /** Adds to the newest point how near the arm is to limits: it has the nearest of its stretch. */
  private void note(FrameMargins margins) {
    int at = newest() + TcpTrace.MARGINS;
    for (Margin each : MARGINS) {
      int index = at + each.index();
      ring[index] = Math.max(ring[index], (float) each.used(margins.value(each)));
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
   * Adds a place. One of another tool begins a new line: nothing has moved there.
   *
   * @param timeS robot time, s
   * @return whether it is the newest point now; not if the arm has hardly moved, or the place is
   *     not known
   */
  boolean add(Pose inBase, Pose tcpInFlange, double timeS, int programLine) {
    double x = inBase.x();
    double y = inBase.y();
    double z = inBase.z();
    boolean begins = Double.isNaN(lastS) || timeS < lastS || !tool.equals(tcpInFlange);
    boolean moved = begins || distance(x, y, z, lastX, lastY, lastZ) >= STILL_M;
    if (!moved || timeS == lastS || Double.isNaN(x + y + z)) {
      return false;
    }
    if (!begins && goesOn(x, y, z, timeS, programLine)) {
      passed[3 * passedCount] = lastX;
      passed[3 * passedCount + 1] = lastY;
      passed[3 * passedCount + 2] = lastZ;
      passedCount++;
    } else {
      fromX = lastX;
      fromY = lastY;
      fromZ = lastZ;
      fromS = lastS;
      passedCount = 0;
      begun = begins;
      count++;
      clearMargins();
    }
    lastX = x;
    lastY = y;
    lastZ = z;
    lastS = timeS;
    line = programLine;
    tool = tcpInFlange;
    write();
    snapshot = Optional.empty();
    return true;
  }

  /** Whether the newest point may move to a place: the line shows all that it has passed. */
  private boolean goesOn(double x, double y, double z, double timeS, int programLine) {
    if (begun || programLine != line || passedCount == MAX_PASSED) {
      return false;
    }
    if (timeS - fromS > MAX_STEP_S && distance(x, y, z, fromX, fromY, fromZ) > SPACING_M) {
      return false;
    }
    if (fromLine(lastX, lastY, lastZ, x, y, z) > TOLERANCE_M) {
      return false;
    }
    for (int i = 0; i < passedCount; i++) {
      if (fromLine(passed[3 * i], passed[3 * i + 1], passed[3 * i + 2], x, y, z) > TOLERANCE_M) {
        return false;
      }
    }
    return true;
  }

  /** How far a place is from the line that would lead to {@code x, y, z}, m. */
  private double fromLine(double px, double py, double pz, double x, double y, double z) {
    double dx = x - fromX;
    double dy = y - fromY;
    double dz = z - fromZ;
    double squared = dx * dx + dy * dy + dz * dz;
    double along = (px - fromX) * dx + (py - fromY) * dy + (pz - fromZ) * dz;
    double share = squared == 0 ? 0 : Math.clamp(along / squared, 0, 1);
    return distance(px, py, pz, fromX + share * dx, fromY + share * dy, fromZ + share * dz);
  }

  private static double distance(double x, double y, double z, double x2, double y2, double z2) {
    double dx = x - x2;
    double dy = y - y2;
    double dz = z - z2;
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  /** Where the numbers of the newest point begin. */
  private int newest() {
    return (int) ((count - 1) % capacity) * TcpTrace.STRIDE;
  }

  private void clearMargins() {
    int at = newest() + TcpTrace.MARGINS;
    for (int i = 0; i < MARGINS.size(); i++) {
      ring[at + i] = 0;
    }
  }

  private void write() {
    int at = newest();
    double stepM = distance(lastX, lastY, lastZ, fromX, fromY, fromZ);
    ring[at] = (float) lastX;
    ring[at + 1] = (float) lastY;
    ring[at + 2] = (float) lastZ;
    ring[at + 3] = begun ? -1 : (float) (stepM / (lastS - fromS));
    ring[at + 4] = line;
    ring[at + 5] = (float) lastS;
  }

  /** Forgets everything. */
  public void clear() {
    count = 0;
    interrupt();
    snapshot = Optional.of(TcpTrace.EMPTY);
  }

  /** The next place begins a new line: it is not known what was before it. */
  void interrupt() {
    lastS = Double.NaN;
  }

  /** How many points there were since it was made or cleared, forgotten ones included. */
  long count() {
    return count;
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
}
