package org.pendant.recording.compare;

import org.pendant.controller.quantity.StateQuantity;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

/**
 * TCP path: how far the TCP of a recording is from the path of Pendant's. Both are worked out from
 * the joints with the same arm and the same TCP, so that the calibration of one arm and the TCP
 * that it was set to do not count.
 */
final class TcpPath {
  /** How far along Pendant's run the nearest point is looked for, s to either side. */
  private static final double WINDOW_S = 0.25;

  private final double[] distancesM;

  private TcpPath(double[] distancesM) {
    this.distancesM = distancesM;
  }

  /**
   * The distance of each sample.
   *
   * @param shiftS what a time of the recording has to be increased by
   * @param joints the positions, which both have
   */
  static TcpPath of(
      Samples recorded,
      Samples pendant,
      double shiftS,
      StateQuantity joints,
      ForwardKinematics kinematics) {
    double[][] path = new double[pendant.rows()][];
    for (int row = 0; row < path.length; row++) {
      path[row] =
          tcp(
              kinematics,
              pendant.values(joints, row),
              pendant.values(SampledQuantity.TCP_OFFSET, row));
    }
    double[] distancesM = new double[recorded.rows()];
    for (int row = 0; row < distancesM.length; row++) {
      double timeS = recorded.timeS(row) + shiftS;
      double[] offset = pendant.values(SampledQuantity.TCP_OFFSET, pendant.rowBefore(timeS));
      double[] point = tcp(kinematics, recorded.values(joints, row), offset);
      int from = pendant.rowBefore(timeS - WINDOW_S);
      int end = pendant.rowBefore(timeS + WINDOW_S);
      double nearest = distance(point, path[from], path[from]);
      for (int i = from; i < end; i++) {
        nearest = Math.min(nearest, distance(point, path[i], path[i + 1]));
      }
      distancesM[row] = nearest;
    }
    return new TcpPath(distancesM);
  }

  private static double[] tcp(ForwardKinematics kinematics, double[] q, double[] offset) {
    Pose tool = new Pose(offset[0], offset[1], offset[2], offset[3], offset[4], offset[5]);
    Pose tcp = kinematics.tcpPose(Joints.of(q), tool);
    return new double[] {tcp.x(), tcp.y(), tcp.z()};
  }

  /** Of a point from the straight line between two others. */
  private static double distance(double[] point, double[] from, double[] to) {
    double along = 0;
    double length = 0;
    for (int i = 0; i < point.length; i++) {
      along += (point[i] - from[i]) * (to[i] - from[i]);
      length += (to[i] - from[i]) * (to[i] - from[i]);
    }
    double part = length > 0 ? Math.clamp(along / length, 0, 1) : 0;
    double squares = 0;
    for (int i = 0; i < point.length; i++) {
      double difference = point[i] - from[i] - part * (to[i] - from[i]);
      squares += difference * difference;
    }
    return Math.sqrt(squares);
  }

  double meanM() {
    double sum = 0;
    for (double each : distancesM) {
      sum += each;
    }
    return sum / distancesM.length;
  }

  double largestM() {
    double largest = 0;
    for (double each : distancesM) {
      largest = Math.max(largest, each);
    }
    return largest;
  }
}
