package org.pendant.models.arm;

/**
 * Joint vector: six numbers, one a joint from base to wrist 3: positions in rad, speeds in rad/s,
 * torques in Nm, whatever the name of the variable says.
 */
public record Joints(double q0, double q1, double q2, double q3, double q4, double q5) {
  /** Number of joints. */
  public static final int COUNT = 6;

  /** All six zero. */
  public static final Joints ZERO = new Joints(0, 0, 0, 0, 0, 0);

  /**
   * Makes a value of exactly six numbers.
   *
   * @throws IllegalArgumentException if there are not exactly six
   */
  public static Joints of(double... values) {
    if (values.length != COUNT) {
      throw new IllegalArgumentException(
          "joints: has " + values.length + " values, must have " + COUNT);
    }
    return new Joints(values[0], values[1], values[2], values[3], values[4], values[5]);
  }

  /**
   * Value of joint i, 0 for the base to 5 for wrist 3.
   *
   * @throws IndexOutOfBoundsException if i is not 0 to 5
   */
  public double get(int i) {
    return switch (i) {
      case 0 -> q0;
      case 1 -> q1;
      case 2 -> q2;
      case 3 -> q3;
      case 4 -> q4;
      case 5 -> q5;
      default -> throw outside(i);
    };
  }

  /**
   * These values with that of joint i replaced by v.
   *
   * @throws IndexOutOfBoundsException if i is not 0 to 5
   */
  public Joints with(int i, double v) {
    return switch (i) {
      case 0 -> new Joints(v, q1, q2, q3, q4, q5);
      case 1 -> new Joints(q0, v, q2, q3, q4, q5);
      case 2 -> new Joints(q0, q1, v, q3, q4, q5);
      case 3 -> new Joints(q0, q1, q2, v, q4, q5);
      case 4 -> new Joints(q0, q1, q2, q3, v, q5);
      case 5 -> new Joints(q0, q1, q2, q3, q4, v);
      default -> throw outside(i);
    };
  }

  /** The six values, in a new array. */
  public double[] toArray() {
    return new double[] {q0, q1, q2, q3, q4, q5};
  }

  /** Writes the six values into {@code target[0..5]}. */
  public void copyTo(double[] target) {
    target[0] = q0;
    target[1] = q1;
    target[2] = q2;
    target[3] = q3;
    target[4] = q4;
    target[5] = q5;
  }

  /** Largest absolute difference of any joint. */
  public double maxAbsDifference(Joints other) {
    double largest = 0;
    for (int i = 0; i < COUNT; i++) {
      largest = Math.max(largest, Math.abs(get(i) - other.get(i)));
    }
    return largest;
  }

  /** Sum of the squared differences of the joints. */
  public double squaredDistance(Joints other) {
    double sum = 0;
    for (int i = 0; i < COUNT; i++) {
      double difference = get(i) - other.get(i);
      sum += difference * difference;
    }
    return sum;
  }

  /** True if no value is infinite or not a number. */
  public boolean isFinite() {
    return Double.isFinite(q0)
        && Double.isFinite(q1)
        && Double.isFinite(q2)
        && Double.isFinite(q3)
        && Double.isFinite(q4)
        && Double.isFinite(q5);
  }

  private static IndexOutOfBoundsException outside(int i) {
    return new IndexOutOfBoundsException("joints: index is " + i + ", must be 0 to 5");
  }
}
