package org.pendant.motion;

import java.util.List;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Tool wrench limit: how strongly the payload may pull at the tool by being accelerated (manual
 * 15.53).
 *
 * @param frameInFlange where force and moment count, in the flange frame
 * @param limits of the forces along the frame's axes, N, and the moments about them, Nm; each above
 *     0, infinite where nothing is limited
 */
public record ToolWrenchLimit(Pose frameInFlange, List<Double> limits) {
  /** Checks the count and copies the list. */
  public ToolWrenchLimit {
    limits = List.copyOf(limits);
    if (limits.size() != Pose.SIZE) {
      throw new IllegalArgumentException(
          "tool wrench limit: has " + limits.size() + " limits, must have " + Pose.SIZE);
    }
  }

  /**
   * Moves a wrench to the frame.
   *
   * @param wrench force in N and torque in Nm about the origin of the flange, along its axes;
   *     overwritten by those about the origin of the frame, along its axes
   */
  void carry(double[] wrench) {
    carry(wrench, transform());
  }

  /** The frame as a transformation, for {@link #carry(double[], double[])}. */
  double[] transform() {
    double[] frame = new double[Transforms.SIZE];
    Transforms.of(frameInFlange, frame);
    return frame;
  }

  /** As {@link #carry(double[])}, with what {@link #transform} gives. */
  static void carry(double[] wrench, double[] frame) {
    double fx = wrench[0];
    double fy = wrench[1];
    double fz = wrench[2];
    double nx = wrench[3] - (frame[10] * fz - frame[11] * fy);
    double ny = wrench[4] - (frame[11] * fx - frame[9] * fz);
    double nz = wrench[5] - (frame[9] * fy - frame[10] * fx);
    for (int i = 0; i < 3; i++) {
      wrench[i] = frame[i] * fx + frame[3 + i] * fy + frame[6 + i] * fz;
      wrench[3 + i] = frame[i] * nx + frame[3 + i] * ny + frame[6 + i] * nz;
    }
  }
}
