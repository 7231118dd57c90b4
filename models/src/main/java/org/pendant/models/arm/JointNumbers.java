package org.pendant.models.arm;

import java.util.Arrays;
import org.pendant.models.time.FrameTime;

/**
 * Six numbers of the frame loop, one per joint, that change from frame to frame. Changing them
 * allocates nothing; a value of them that lasts is made on demand, and once only as long as they
 * stay as they are.
 */
public final class JointNumbers {
  private static final int N = Joints.COUNT;

  private final double[] numbers = new double[N];
  private Joints lasting = Joints.ZERO;
  private boolean made = true;

  /** Numbers that are those of a lasting value at first. */
  public static JointNumbers of(Joints values) {
    JointNumbers numbers = new JointNumbers();
    numbers.set(values);
    return numbers;
  }

  /** The numbers; only to be read, and different in the next frame. */
  public double[] numbers() {
    return numbers;
  }

  /** The numbers as they are now, for good. */
  public Joints joints() {
    if (!made) {
      lasting = isZero() ? Joints.ZERO : Joints.of(numbers);
      made = true;
    }
    return lasting;
  }

  /** Number of joint {@code i}, 0 for the base to 5 for wrist 3. */
  public double get(int i) {
    return numbers[i];
  }

  /** Writes {@link #joints} into six numbers. */
  public void copyTo(double[] target) {
    if (isZero()) {
      Arrays.fill(target, 0);
    } else {
      System.arraycopy(numbers, 0, target, 0, N);
    }
  }

  /** Whether {@link #joints} of both are equal. */
  public boolean same(JointNumbers others) {
    return Arrays.equals(numbers, others.numbers) || (isZero() && others.isZero());
  }

  /** Whether all are 0. */
  public boolean isZero() {
    for (int i = 0; i < N; i++) {
      if (numbers[i] != 0) {
        return false;
      }
    }
    return true;
  }

  /** The largest of them, signs aside. */
  public double largest() {
    double largest = 0;
    for (int i = 0; i < N; i++) {
      largest = Math.max(largest, Math.abs(numbers[i]));
    }
    return largest;
  }

  /** Takes over a lasting value. */
  public void set(Joints values) {
    values.copyTo(numbers);
    lasting = values;
    made = true;
  }

  /** Takes over the numbers of others as they are now. */
  public void set(JointNumbers others) {
    System.arraycopy(others.numbers, 0, numbers, 0, N);
    lasting = others.lasting;
    made = others.made;
  }

  /** Takes over six numbers. */
  public void set(double[] values) {
    System.arraycopy(values, 0, numbers, 0, N);
    made = false;
  }

  /** As {@link #set(double[])}; the same lasting value as long as the numbers stay as they are. */
  public void update(double[] values) {
    if (!Arrays.equals(values, numbers)) {
      set(values);
    }
  }

  /** Makes all 0. */
  public void setZero() {
    Arrays.fill(numbers, 0);
    lasting = Joints.ZERO;
    made = true;
  }

  /** Sets the sum of {@code f} times {@code x} and {@code g} times {@code y}. */
  public void setSum(double f, double[] x, double g, double[] y) {
    for (int i = 0; i < N; i++) {
      numbers[i] = f * x[i] + g * y[i];
    }
    made = false;
  }

  /** Sets how fast numbers have changed within a frame, per second. */
  public void setRate(JointNumbers before, JointNumbers after) {
    double f = 1 / FrameTime.FRAME_S;
    for (int i = 0; i < N; i++) {
      numbers[i] = (after.numbers[i] - before.numbers[i]) * f;
    }
    made = false;
  }
}
