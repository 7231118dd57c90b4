package org.pendant.motion;

import java.util.Arrays;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * Six numbers of the frame loop, one per joint, that change from frame to frame. Changing them
 * allocates nothing; a value of them that lasts is made on demand, and once only as long as they
 * stay as they are.
 */
final class JointNumbers {
  private static final int N = Joints.COUNT;

  private final double[] numbers = new double[N];
  private Joints lasting = Joints.ZERO;
  private boolean made = true;

  /** The numbers; only to be read, and different in the next frame. */
  double[] numbers() {
    return numbers;
  }

  /** The numbers as they are now, for good. */
  Joints joints() {
    if (!made) {
      lasting = isZero() ? Joints.ZERO : Joints.of(numbers);
      made = true;
    }
    return lasting;
  }

  /** Whether all are 0. */
  boolean isZero() {
    for (int i = 0; i < N; i++) {
      if (numbers[i] != 0) {
        return false;
      }
    }
    return true;
  }

  /** The largest of them, signs aside. */
  double largest() {
    double largest = 0;
    for (int i = 0; i < N; i++) {
      largest = Math.max(largest, Math.abs(numbers[i]));
    }
    return largest;
  }

  void set(Joints values) {
    values.copyTo(numbers);
    lasting = values;
    made = true;
  }

  void set(JointNumbers others) {
    System.arraycopy(others.numbers, 0, numbers, 0, N);
    lasting = others.lasting;
    made = others.made;
  }

  void set(double[] values) {
    System.arraycopy(values, 0, numbers, 0, N);
    made = false;
  }

  void setZero() {
    Arrays.fill(numbers, 0);
    lasting = Joints.ZERO;
    made = true;
  }

  /** Sets the sum of {@code f} times {@code x} and {@code g} times {@code y}. */
  void setSum(double f, double[] x, double g, double[] y) {
    for (int i = 0; i < N; i++) {
      numbers[i] = f * x[i] + g * y[i];
    }
    made = false;
  }

  /** Sets how fast numbers have changed within a frame, per second. */
  void setRate(JointNumbers before, JointNumbers after) {
    double f = 1 / FrameTime.FRAME_S;
    for (int i = 0; i < N; i++) {
      numbers[i] = (after.numbers[i] - before.numbers[i]) * f;
    }
    made = false;
  }
}
