package org.pendant.recording.whatif;

import java.util.Arrays;
import org.pendant.models.pose.Pose;

/** TCP way: points that the tool centre point passed, in the base frame, in their order. */
public final class TcpWay {
  /** No way at all. */
  public static final TcpWay NONE = new TcpWay(new float[0]);

  private static final int STRIDE = 3;

  private final float[] numbers;

  private TcpWay(float[] numbers) {
    this.numbers = numbers;
  }

  /** How many points there are. */
  public int size() {
    return numbers.length / STRIDE;
  }

  /** Position of point {@code i}, m. */
  public float x(int i) {
    return numbers[STRIDE * i];
  }

  /** Position of point {@code i}, m. */
  public float y(int i) {
    return numbers[STRIDE * i + 1];
  }

  /** Position of point {@code i}, m. */
  public float z(int i) {
    return numbers[STRIDE * i + 2];
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof TcpWay way && Arrays.equals(numbers, way.numbers);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers);
  }

  @Override
  public String toString() {
    return "way of " + size() + " points";
  }

  /** Collects a way; the longer it gets, the farther apart are its points. */
  static final class Builder {
    private static final double SPACING_M = 1e-3;

    private final float[] numbers;
    private int count;
    private double spacingM = SPACING_M;

    /** At most so many points, an even number. */
    Builder(int most) {
      numbers = new float[STRIDE * most];
    }

    /** Adds where the tool centre point is, unless that is where the last point is. */
    void add(Pose tcpInBase) {
      if (count > 0 && distanceM(tcpInBase) < spacingM) {
        return;
      }
      if (STRIDE * count == numbers.length) {
        thin();
      }
      numbers[STRIDE * count] = (float) tcpInBase.x();
      numbers[STRIDE * count + 1] = (float) tcpInBase.y();
      numbers[STRIDE * count + 2] = (float) tcpInBase.z();
      count++;
    }

    private double distanceM(Pose pose) {
      int last = STRIDE * (count - 1);
      double x = pose.x() - numbers[last];
      double y = pose.y() - numbers[last + 1];
      double z = pose.z() - numbers[last + 2];
      return Math.sqrt(x * x + y * y + z * z);
    }

    private void thin() {
      count /= 2;
      for (int i = 0; i < count; i++) {
        System.arraycopy(numbers, 2 * STRIDE * i, numbers, STRIDE * i, STRIDE);
      }
      spacingM *= 2;
    }

    TcpWay way() {
      return new TcpWay(Arrays.copyOf(numbers, STRIDE * count));
    }
  }
}
