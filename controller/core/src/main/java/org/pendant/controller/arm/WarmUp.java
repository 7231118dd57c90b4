package org.pendant.controller.arm;

/**
 * Warm-up: how something gets warmer after it was switched on.
 *
 * @param coldC temperature before, degrees Celsius
 * @param warmC temperature in the end, degrees Celsius
 * @param timeConstantS when 63 % of the difference are done, s, above 0
 */
public record WarmUp(double coldC, double warmC, double timeConstantS) {
  /** The controller's board in its box. */
  public static final WarmUp CONTROL_BOX = new WarmUp(JointHeat.AMBIENT_C, 38, 900);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the time constant is not above 0 s
   */
  public WarmUp {
    if (!(timeConstantS > 0)) {
      throw new IllegalArgumentException(
          "warm-up: time constant is " + timeConstantS + " s, must be above 0");
    }
  }

  /** The temperature {@code secondsOn} s after switching on, degrees Celsius. */
  public double temperatureC(double secondsOn) {
    return warmC + (coldC - warmC) * Math.exp(-secondsOn / timeConstantS);
  }
}
