package org.pendant.desktop.unit;

import java.util.List;
import org.pendant.models.pose.Rotations;

/** Rotation form: how a rotation is written in three angles. */
public enum RotationForm {
  VECTOR("Rotation vector") {
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
  },
  /** Turns about the fixed axes x, y and z, in this order. */
  ROLL_PITCH_YAW("Roll, pitch, yaw") {
    @Override
    public List<String> labels() {
      return List.of("Roll", "Pitch", "Yaw");
    }

    @Override
    public void fromVector(double rx, double ry, double rz, double[] angles) {
      Rotations.vectorToRpy(rx, ry, rz, angles);
    }

    @Override
    public void toVector(double a, double b, double c, double[] vector) {
      Rotations.rpyToVector(a, b, c, vector);
    }
  };

  private final String title;

  RotationForm(String title) {
    this.title = title;
  }

  /** Rotation vector to the three angles, all in rad. */
  public abstract void fromVector(double rx, double ry, double rz, double[] angles);

  /** The three angles to a rotation vector, all in rad. */
  public abstract void toVector(double a, double b, double c, double[] vector);

  /** Names of the three angles. */
  public abstract List<String> labels();

  @Override
  public String toString() {
    return title;
  }
}
