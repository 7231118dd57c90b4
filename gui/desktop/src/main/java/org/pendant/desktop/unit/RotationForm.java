package org.pendant.desktop.unit;

import static org.pendant.desktop.unit.UnitTexts.text;

import java.util.List;
import org.pendant.models.pose.Rotations;

/** Rotation form: how a rotation is written in three angles. */
public enum RotationForm {
  VECTOR(text("rotationVector")) {
    @Override
    public List<String> labels() {
      return List.of("RX", "RY", "RZ");
    }

    @Override
    public void fromVector(double rx, double ry, double rz, double[] angles) {
      angles[0] = rx;
      angles[1] = ry;
      angles[2] = rz;
    }

    @Override
    public void toVector(double a, double b, double c, double[] vector) {
      fromVector(a, b, c, vector);
    }

    @Override
    void settle(double[] angles) {
      double angle = Math.hypot(Math.hypot(angles[0], angles[1]), angles[2]);
      if (Math.abs(angle - Math.PI) > HALF_TURN_RAD || firstLarge(angles) > 0) {
        return;
      }
      double other = (angle - 2 * Math.PI) / angle;
      for (int i = 0; i < angles.length; i++) {
        angles[i] *= other;
      }
    }

    private double firstLarge(double[] angles) {
      for (double each : angles) {
        if (Math.abs(each) > LARGE_RAD) {
          return each;
        }
      }
      return 0;
    }
  },
  /** Turns about the fixed axes x, y and z, in this order. */
  ROLL_PITCH_YAW(text("rollPitchYaw")) {
    @Override
    public List<String> labels() {
      return List.of(text("roll"), text("pitch"), text("yaw"));
    }

    @Override
    public void fromVector(double rx, double ry, double rz, double[] angles) {
      Rotations.vectorToRpy(rx, ry, rz, angles);
    }

    @Override
    public void toVector(double a, double b, double c, double[] vector) {
      Rotations.rpyToVector(a, b, c, vector);
    }

    @Override
    void settle(double[] angles) {
      for (int i = 0; i < angles.length; i++) {
        if (angles[i] < HALF_TURN_RAD - Math.PI) {
          angles[i] += 2 * Math.PI;
        }
      }
    }
  };

  /** So near to half a turn a rotation counts as one: more than noise, less than people mean. */
  private static final double HALF_TURN_RAD = Math.toRadians(0.5);

  /** From here on a part of a rotation vector of half a turn is not taken for zero with noise. */
  private static final double LARGE_RAD = Math.toRadians(2);

  private final String title;

  RotationForm(String title) {
    this.title = title;
  }

  /** Rotation vector to the three angles, all in rad. */
  public abstract void fromVector(double rx, double ry, double rz, double[] angles);

  /** The three angles to a rotation vector, all in rad. */
  public abstract void toVector(double a, double b, double c, double[] vector);

  /**
   * Half a turn is the same in both directions, so that noise would change its sign from frame to
   * frame. Of a rotation vector within 0.5 degrees of half a turn the first of RX, RY, RZ that is
   * not about zero (beyond 2 degrees) gets positive, and so does each of roll, pitch and yaw.
   * Angles in rad, written over; they stay the same rotation.
   */
  abstract void settle(double[] angles);

  /** Names of the three angles. */
  public abstract List<String> labels();

  @Override
  public String toString() {
    return title;
  }
}
