package org.pendant.models.pose;

/**
 * Force and torque in the frame loop, which change from frame to frame. Changing them allocates
 * nothing; a {@link Wrench} of them that lasts is made on demand, and once only as long as they
 * stay as they are.
 */
public final class WrenchNumbers {
  private static final int N = 6;

  private final double[] numbers = new double[N];
  private Wrench lasting = Wrench.ZERO;
  private boolean made = true;

  /** Numbers that are those of a lasting value at first. */
  public static WrenchNumbers of(Wrench wrench) {
    WrenchNumbers numbers = new WrenchNumbers();
    numbers.set(wrench);
    return numbers;
  }

  /** Component {@code i}: forces along x, y and z in N, then torques about them in Nm. */
  public double get(int i) {
    return numbers[i];
  }

  /** The numbers as they are now, for good. */
  public Wrench wrench() {
    if (!made) {
      lasting = new Wrench(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]);
      made = true;
    }
    return lasting;
  }

  /** Takes over six numbers, forces before torques. */
  public void set(double fx, double fy, double fz, double mx, double my, double mz) {
    numbers[0] = fx;
    numbers[1] = fy;
    numbers[2] = fz;
    numbers[3] = mx;
    numbers[4] = my;
    numbers[5] = mz;
    made = false;
  }

  /** Takes over a lasting value. */
  public void set(Wrench wrench) {
    set(wrench.fx(), wrench.fy(), wrench.fz(), wrench.mx(), wrench.my(), wrench.mz());
    lasting = wrench;
    made = true;
  }

  /** Takes over the numbers of others as they are now. */
  public void set(WrenchNumbers others) {
    System.arraycopy(others.numbers, 0, numbers, 0, N);
    lasting = others.lasting;
    made = others.made;
  }
}
