package org.pendant.controller.io;

/**
 * Analog domain: whether an analog signal is a voltage or a current (manual 19.2, 19.11, 19.13).
 */
public enum AnalogDomain {
  /** A current of 4 to 20 mA; values are in A. */
  CURRENT(0, 0.004, 0.020, "A"),
  /** A voltage of 0 to 10 V; values are in V. */
  VOLTAGE(1, 0, 10, "V");

  private final int number;
  private final double low;
  private final double high;
  private final String unit;

  AnalogDomain(int number, double low, double high, String unit) {
    this.number = number;
    this.low = low;
    this.high = high;
    this.unit = unit;
  }

  /** The domain that scripts and protocols call by {@code number}, 0 or 1. */
  public static AnalogDomain of(int number) {
    return number == 0 ? CURRENT : VOLTAGE;
  }

  /** What scripts and protocols call it: 0 for a current, 1 for a voltage. */
  public int number() {
    return number;
  }

  /** The lowest value, A or V. */
  public double low() {
    return low;
  }

  /** The highest value, A or V. */
  public double high() {
    return high;
  }

  /** {@code A} or {@code V}. */
  public String unit() {
    return unit;
  }

  /** The value, A or V, at a part of the range, 0 for its low end and 1 for its high one. */
  public double valueAt(double ratio) {
    return low + ratio * (high - low);
  }

  /** Which part of the range a value, A or V, is at: 0 for its low end and 1 for its high one. */
  public double ratioOf(double value) {
    return (value - low) / (high - low);
  }
}
