package org.pendant.sweep.run;

import org.pendant.models.arm.Joints;

/** Joint sums: the largest and the mean square of one quantity of each joint. Mutable. */
final class JointSums {
  private final double[] limits;
  private final double[] peaks = new double[Joints.COUNT];
  private final double[] squares = new double[Joints.COUNT];
  private long frames;

  /** With what each joint can do, in the unit of the quantity; NaN where that is not known. */
  JointSums(double[] limits) {
    this.limits = limits.clone();
  }

  void add(Joints values) {
    frames++;
    for (int i = 0; i < Joints.COUNT; i++) {
      double value = Math.abs(values.get(i));
      peaks[i] = Math.max(peaks[i], value);
      squares[i] += value * value;
    }
  }

  JointLoads loads() {
    double[] rms = new double[Joints.COUNT];
    double[] shares = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      rms[i] = frames == 0 ? 0 : Math.sqrt(squares[i] / frames);
      shares[i] = peaks[i] / limits[i];
    }
    return new JointLoads(Joints.of(peaks), Joints.of(rms), Joints.of(shares));
  }
}
