package org.pendant.desktop.unit;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.pose.Pose;

/**
 * Pose form: how people read and type a pose.
 *
 * @param length unit of the position
 * @param angle unit of the rotation
 */
public record PoseForm(DisplayUnit length, DisplayUnit angle, RotationForm rotation) {
  /** As it is shown at first. */
  public static final PoseForm STANDARD =
      new PoseForm(DisplayUnit.MILLIMETRE, DisplayUnit.DEGREE, RotationForm.VECTOR);

  /** Units of the six numbers. */
  public List<DisplayUnit> units() {
    return List.of(length, length, length, angle, angle, angle);
  }

  /** Names of the six numbers. */
  public List<String> labels() {
    List<String> turns = rotation.labels();
    return List.of("X", "Y", "Z", turns.get(0), turns.get(1), turns.get(2));
  }

  /** The six numbers of a pose, in m and rad; half a turn is always written with the same sign. */
  public double[] numbers(Pose pose) {
    double[] numbers = pose.toArray();
    double[] angles = new double[3];
    rotation.fromVector(pose.rx(), pose.ry(), pose.rz(), angles);
    rotation.settle(angles);
    System.arraycopy(angles, 0, numbers, 3, 3);
    return numbers;
  }

  /** The pose of six numbers, in m and rad. */
  public Pose pose(double[] numbers) {
    double[] vector = new double[3];
    rotation.toVector(numbers[3], numbers[4], numbers[5], vector);
    return new Pose(numbers[0], numbers[1], numbers[2], vector[0], vector[1], vector[2]);
  }

  /** Such as {@code 450.00, -300.00, 150.00 mm}. */
  public String place(Pose pose) {
    return place(pose.x(), pose.y(), pose.z());
  }

  /** As {@link #place(Pose)}, of a point, m. */
  public String place(double x, double y, double z) {
    return String.join(", ", length.text(x), length.text(y), length.text(z))
        + " "
        + length.symbol();
  }

  /** The six numbers as they are read, each with its unit. */
  public List<String> readings(Pose pose) {
    double[] numbers = numbers(pose);
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < numbers.length; i++) {
      texts.add(units().get(i).reading(numbers[i]));
    }
    return texts;
  }

  /** The place in one line and the rotation in the next. */
  public String words(Pose pose) {
    List<String> texts = readings(pose);
    List<String> names = labels();
    StringBuilder turn = new StringBuilder();
    for (int i = 3; i < texts.size(); i++) {
      turn.append(i == 3 ? "" : ", ").append(names.get(i)).append(' ').append(texts.get(i));
    }
    return place(pose) + "\n" + turn;
  }
}
