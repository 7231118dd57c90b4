package org.pendant.models.kinematics;

import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkGeometry;
import org.pendant.models.pose.Transforms;

/**
 * The plain product of six turns and six links, {@code Rz(q_1) L_1 Rz(q_2) L_2 ...}, for an arm
 * whose axes are not exactly parallel or square to each other.
 */
final class CalibratedChain {
  private final double[][] links;

  CalibratedChain(DhLengths dh, LinkGeometry geometry) {
    this(LinkTransforms.of(dh, geometry));
  }

  /** The product of links as {@link LinkTransforms} has them; they are kept. */
  CalibratedChain(double[][] links) {
    this.links = links;
  }

  /** Frames 1 to 6 in the base frame, six transformations, overwritten. */
  void frames(double[] q, double[][] frames) {
    start(q[0], frames[0]);
    for (int i = 1; i < Joints.COUNT; i++) {
      System.arraycopy(frames[i - 1], 0, frames[i], 0, Transforms.SIZE);
      advance(i, q[i], frames[i]);
    }
  }

  /** Frame 6 in the base frame, overwritten. */
  void flange(double[] q, double[] transform) {
    start(q[0], transform);
    for (int i = 1; i < Joints.COUNT; i++) {
      advance(i, q[i], transform);
    }
  }

  private void start(double q, double[] transform) {
    for (int i = 0; i < Transforms.SIZE; i++) {
      transform[i] = i == 0 || i == 4 || i == 8 ? 1 : 0;
    }
    advance(0, q, transform);
  }

  /** Multiplies by the turn of joint i and its link, in place. */
  private void advance(int i, double q, double[] transform) {
    double c = Math.cos(q);
    double s = Math.sin(q);
    double[] link = links[i];
    for (int row = 0; row < 3; row++) {
      int at = 3 * row;
      double x = c * transform[at] + s * transform[at + 1];
      double y = c * transform[at + 1] - s * transform[at];
      double z = transform[at + 2];
      transform[at] = x * link[0] + y * link[3] + z * link[6];
      transform[at + 1] = x * link[1] + y * link[4] + z * link[7];
      transform[at + 2] = x * link[2] + y * link[5] + z * link[8];
      transform[9 + row] += x * link[9] + y * link[10] + z * link[11];
    }
  }
}
