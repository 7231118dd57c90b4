package org.pendant.motion.offset;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/**
 * Conveyor belt geometry: how a conveyor carries what lies on it, over its travel: in m, or in rad
 * for a round one.
 */
sealed interface Belt {

  /**
   * Carries a TCP along. Allocates nothing.
   *
   * @param tcpInBase overwritten
   */
  void carry(double travel, double[] tcpInBase);

  /** How fast a point at a TCP moves at the most for a travel of 1, m. */
  double reachM(double[] tcpInBase);

  /** Along a straight line; the components are those of a unit vector in the base frame. */
  record Linear(double x, double y, double z) implements Belt {

    /** Along a direction of any length above 0. */
    static Linear along(double x, double y, double z) {
      double length = Math.sqrt(x * x + y * y + z * z);
      return new Linear(x / length, y / length, z / length);
    }

    @Override
    public void carry(double travel, double[] tcpInBase) {
      tcpInBase[9] += travel * x;
      tcpInBase[10] += travel * y;
      tcpInBase[11] += travel * z;
    }

    @Override
    public double reachM(double[] tcpInBase) {
      return 1;
    }
  }

  /** About the z axis of a frame. */
  final class Circular implements Belt {
    /** Nearer to the axis, m, it is the turning of the tool that counts. */
    private static final double NEAR_M = 0.25;

    private final Pose centre;
    private final boolean rotatesTool;
    private final double[] axis = new double[3];
    private final double[] rotation = new double[9];
    private final double[] copy = new double[Transforms.SIZE];

    /**
     * A round conveyor.
     *
     * @param centre its frame in the base frame
     * @param rotatesTool whether the tool turns with it, or keeps its orientation
     */
    Circular(Pose centre, boolean rotatesTool) {
      this.centre = centre;
      this.rotatesTool = rotatesTool;
      double[] frame = new double[Transforms.SIZE];
      Transforms.of(centre, frame);
      axis[0] = frame[2];
      axis[1] = frame[5];
      axis[2] = frame[8];
    }

    @Override
    public void carry(double travel, double[] tcpInBase) {
      Rotations.vectorToMatrix(travel * axis[0], travel * axis[1], travel * axis[2], rotation);
      System.arraycopy(tcpInBase, 0, copy, 0, Transforms.SIZE);
      double x = copy[9] - centre.x();
      double y = copy[10] - centre.y();
      double z = copy[11] - centre.z();
      tcpInBase[9] = centre.x() + rotation[0] * x + rotation[1] * y + rotation[2] * z;
      tcpInBase[10] = centre.y() + rotation[3] * x + rotation[4] * y + rotation[5] * z;
      tcpInBase[11] = centre.z() + rotation[6] * x + rotation[7] * y + rotation[8] * z;
      if (rotatesTool) {
        Turns.multiply(rotation, copy, tcpInBase);
      }
    }

    @Override
    public double reachM(double[] tcpInBase) {
      double x = tcpInBase[9] - centre.x();
      double y = tcpInBase[10] - centre.y();
      double z = tcpInBase[11] - centre.z();
      double along = axis[0] * x + axis[1] * y + axis[2] * z;
      return Math.max(NEAR_M, Math.sqrt(Math.max(0, x * x + y * y + z * z - along * along)));
    }
  }
}
