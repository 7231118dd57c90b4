package org.pendant.models.pose;

/**
 * A force and a torque at the origin of a frame, along that frame's axes.
 *
 * @param fx force in N
 * @param fy force in N
 * @param fz force in N
 * @param mx torque in Nm about the frame's origin
 * @param my torque in Nm about the frame's origin
 * @param mz torque in Nm about the frame's origin
 */
public record Wrench(double fx, double fy, double fz, double mx, double my, double mz) {
  /** No force and no torque. */
  public static final Wrench ZERO = new Wrench(0, 0, 0, 0, 0, 0);

  /**
   * The same load seen from another frame (wrench_trans, manual 17.35).
   *
   * <p>{@code toInFrom} is the pose (R, p) of the new frame in the present one. A load does not
   * change by being looked at from elsewhere: its force is the same vector, and its moment about
   * the new origin is {@code m - p x f}; both are then expressed along the new axes:
   *
   * <pre>
   *   f_to = R^T f
   *   m_to = R^T (m - p x f)
   * </pre>
   *
   * <p>The manual gives only {@code w_to = T_from->to * w_from}, which would fit the opposite
   * direction, too. Its example of manual 16.32 decides: it turns a wrench at the tool flange into
   * the one at the TCP with the TCP offset, the pose of the TCP in the flange frame, as first
   * argument. (K. M. Lynch and F. C. Park, "Modern Robotics", section 3.4, equation 3.98: the
   * transposed adjoint.)
   */
  public Wrench seenFrom(Pose toInFrom) {
    double[] r = new double[9];
    Rotations.vectorToMatrix(toInFrom.rx(), toInFrom.ry(), toInFrom.rz(), r);
    double nx = mx - (toInFrom.y() * fz - toInFrom.z() * fy);
    double ny = my - (toInFrom.z() * fx - toInFrom.x() * fz);
    double nz = mz - (toInFrom.x() * fy - toInFrom.y() * fx);
    return new Wrench(
        r[0] * fx + r[3] * fy + r[6] * fz,
        r[1] * fx + r[4] * fy + r[7] * fz,
        r[2] * fx + r[5] * fy + r[8] * fz,
        r[0] * nx + r[3] * ny + r[6] * nz,
        r[1] * nx + r[4] * ny + r[7] * nz,
        r[2] * nx + r[5] * ny + r[8] * nz);
  }
}
