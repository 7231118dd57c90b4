package org.pendant.controller.io;

/**
 * An analog signal at one moment.
 *
 * @param value what the box reads or puts out, A or V as the domain says, within its range
 */
public record AnalogSignal(double value, AnalogDomain domain) {
  /** The part of the domain's range that the value is at, 0 to 1. */
  public double ratio() {
    return domain.ratioOf(value);
  }
}
