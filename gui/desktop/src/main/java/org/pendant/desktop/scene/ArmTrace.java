package org.pendant.desktop.scene;

import java.util.Optional;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.recording.lines.FrameMargins;
import org.pendant.recording.lines.Margin;

/**
 * Arm trace: remembers where the tool centre point and the elbow have been; the oldest points are
 * forgotten. Belongs to one thread.
 */
public final class ArmTrace {
  /** The Denavit-Hartenberg frame whose origin is the elbow: the end of the upper arm. */
  private static final int ELBOW = 1;

  private static final int POSITION = 9;

  private final int capacity;
  private final double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
  private final TraceRing tool;
  private final TraceRing elbow;
  private TcpTrace toolNow = TcpTrace.EMPTY;
  private TcpTrace elbowNow = TcpTrace.EMPTY;
  private TcpTrace both = TcpTrace.EMPTY;

  /**
   * @param capacity points of each that are remembered, at least 2
   */
  public ArmTrace(int capacity) {
    this.capacity = capacity;
    tool = new TraceRing(capacity);
    elbow = new TraceRing(capacity);
  }

  /** Adds where the arm is, as far as it has moved, and how near it is to limits. */
  public void add(ControllerState state, FrameMargins margins) {
    tool.add(state, margins);
    elbow.add(elbowInBase(state.arm()), state, margins);
  }

  private Pose elbowInBase(ArmState arm) {
    arm.kinematics().frames(arm.actualPositionRad().toArray(), frames);
    double[] at = frames[ELBOW];
    return new Pose(at[POSITION], at[POSITION + 1], at[POSITION + 2], 0, 0, 0);
  }

  /** Has traces coloured by a margin; empty for the speed. */
  public void colourBy(Optional<Margin> margin) {
    tool.colourBy(margin);
    elbow.colourBy(margin);
  }

  /** Forgets everything. */
  public void clear() {
    tool.clear();
    elbow.clear();
  }

  /** The next place begins a new line: it is not known what was before it. */
  void interrupt() {
    tool.interrupt();
    elbow.interrupt();
  }

  /**
   * How many points of the tool there were since it was made or cleared, forgotten ones included.
   */
  long count() {
    return tool.count();
  }

  /** Whether no point of the tool is forgotten. */
  boolean whole() {
    return tool.count() <= capacity;
  }

  /**
   * What is remembered; the same object until something is added.
   *
   * @param withElbow whether the way of the elbow is part of it
   */
  public TcpTrace trace(boolean withElbow) {
    if (!withElbow) {
      return tool.trace();
    }
    if (toolNow != tool.trace() || elbowNow != elbow.trace()) {
      toolNow = tool.trace();
      elbowNow = elbow.trace();
      both = toolNow.withElbow(elbowNow);
    }
    return both;
  }
}
