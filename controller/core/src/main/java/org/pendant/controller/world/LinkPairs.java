package org.pendant.controller.world;

import org.pendant.models.pose.Pose;

/** Link pairs: what links of an arm can get into, pair by pair. They are numbered from 0. */
interface LinkPairs {
  /** How many there are. */
  int pairs();

  /** Takes six joint positions, rad. */
  void at(double[] positionRad);

  /** How far any of the two of a pair has moved at most against the other since {@link #at}, m. */
  double travelM(double[] positionRad);

  /**
   * How far the two of a pair are apart, m: below 0 by the depth where they overlap.
   *
   * @param farM from here on it need not be exact, m
   */
  double distanceM(int pair, double farM);

  /** Whether the tool is no longer than the flange: then it is wrist 3 that presses on things. */
  boolean bareFlange(Pose tcpInFlange);

  /** Whether a pair is that of wrist 3 and something that it presses on. */
  boolean presses(int pair);

  /** The two of a pair, as one that overlaps by so much. */
  LinkHit hit(int pair, double depthM);
}
