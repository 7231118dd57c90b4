package org.pendant.sweep.plan;

import org.hipparchus.random.SobolSequenceGenerator;

/**
 * Points of a Sobol sequence (Joe and Kuo, 2008), each shifted by the same random step from the
 * seed, around the ends of its range (Cranley and Patterson, 1976).
 */
final class SobolPoints {
  private SobolPoints() {}

  /**
   * One point.
   *
   * @param number of the point, from 0, below 2^31
   * @return a number from 0, and below 1, for each dimension
   */
  static double[] point(int dimension, long number, long seed) {
    // what is in it is worked out anew for each number: any thread may ask for any of them
    double[] point = new SobolSequenceGenerator(dimension).skipTo((int) number);
    for (int i = 0; i < dimension; i++) {
      double shifted = seed == 0 ? point[i] : point[i] + UnitNumbers.at(seed, -1, i);
      point[i] = shifted - Math.floor(shifted);
    }
    return point;
  }
}
