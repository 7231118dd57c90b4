package org.pendant.motion.servo;

import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/**
 * Fading rotation: how an orientation that turns already gets to another one: what it does fades
 * out evenly, and what is then missing is added smoothly, {@code R(t) = exp(w h(t)) exp(k g(t))
 * R(0)} with the first angular velocity w, the missing rotation vector k, and {@code g = 3 u^2 - 2
 * u^3}.
 */
final class FadingTurn {
  private final double[] start;
  private final double[] spin;
  private final double[] missing = new double[3];
  private final double fadeS;
  private final double lastsS;
  private final double[] faded = new double[Transforms.SIZE];
  private final double[] added = new double[Transforms.SIZE];
  private final double[] product = new double[Transforms.SIZE];

  /**
   * A turn.
   *
   * @param start transformation at its start; its position does not count
   * @param spinRadPerS angular velocity there, three numbers along the axes of the base
   * @param end transformation at its end
   * @param leastS how long it takes at least, s
   * @param speedRadPerS limit for what is added, above 0
   * @param accelerationRadPerS2 limit for each of the two parts, above 0
   */
  FadingTurn(
      double[] start,
      double[] spinRadPerS,
      double[] end,
      double leastS,
      double speedRadPerS,
      double accelerationRadPerS2) {
    this.start = start;
    spin = spinRadPerS;
    fadeS = TangentArc.length(spin) / accelerationRadPerS2;
    double[] inverse = new double[Transforms.SIZE];
    double[] back = new double[Transforms.SIZE];
    Rotations.vectorToMatrix(
        -0.5 * fadeS * spin[0], -0.5 * fadeS * spin[1], -0.5 * fadeS * spin[2], faded);
    Transforms.invert(start, inverse);
    Transforms.multiply(end, inverse, back);
    Transforms.multiply(faded, back, product);
    Rotations.matrixToVector(product, missing);
    double angle = TangentArc.length(missing);
    double shortest =
        Math.max(1.5 * angle / speedRadPerS, Math.sqrt(6 * angle / accelerationRadPerS2));
    lastsS = Math.max(Math.max(leastS, fadeS), shortest);
  }

  /** How long it takes, s. */
  double durationS() {
    return lastsS;
  }

  private double fade(double timeS) {
    return timeS < fadeS ? timeS - 0.5 * timeS * timeS / fadeS : 0.5 * fadeS;
  }

  private double share(double timeS) {
    double u = timeS < lastsS ? timeS / lastsS : 1;
    return u * u * (3 - 2 * u);
  }

  private double sharePerS(double timeS) {
    double u = timeS / lastsS;
    return timeS < lastsS ? 6 * u * (1 - u) / lastsS : 0;
  }

  private double sharePerS2(double timeS) {
    return timeS < lastsS ? 6 * (1 - 2 * timeS / lastsS) / lastsS / lastsS : 0;
  }

  /** Writes the rotation at a time to {@code transform[0..8]} and zeros behind. */
  void at(double timeS, double[] transform) {
    fadeTo(timeS);
    double g = share(timeS);
    Rotations.vectorToMatrix(g * missing[0], g * missing[1], g * missing[2], added);
    Transforms.multiply(faded, added, product);
    Transforms.multiply(product, start, transform);
  }

  private void fadeTo(double timeS) {
    double h = fade(timeS);
    Rotations.vectorToMatrix(h * spin[0], h * spin[1], h * spin[2], faded);
  }

  /** Writes the angular velocity at a time to {@code twist[3..5]}. */
  void velocity(double timeS, double[] twist) {
    fadeTo(timeS);
    double left = timeS < fadeS ? 1 - timeS / fadeS : 0;
    double gain = sharePerS(timeS);
    for (int i = 0; i < 3; i++) {
      twist[3 + i] = left * spin[i] + gain * missingTurned(i);
    }
  }

  /** Writes the angular acceleration at a time to {@code twist[3..5]}. */
  void acceleration(double timeS, double[] twist) {
    fadeTo(timeS);
    double left = timeS < fadeS ? 1 - timeS / fadeS : 0;
    double slowing = timeS < fadeS ? -1 / fadeS : 0;
    double gain = sharePerS(timeS);
    double gainChange = sharePerS2(timeS);
    double x = missingTurned(0);
    double y = missingTurned(1);
    double z = missingTurned(2);
    double f = left * gain;
    twist[3] = slowing * spin[0] + gainChange * x + f * (spin[1] * z - spin[2] * y);
    twist[4] = slowing * spin[1] + gainChange * y + f * (spin[2] * x - spin[0] * z);
    twist[5] = slowing * spin[2] + gainChange * z + f * (spin[0] * y - spin[1] * x);
  }

  private double missingTurned(int row) {
    int at = 3 * row;
    return faded[at] * missing[0] + faded[at + 1] * missing[1] + faded[at + 2] * missing[2];
  }
}
