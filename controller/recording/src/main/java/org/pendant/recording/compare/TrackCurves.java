package org.pendant.recording.compare;

import java.util.List;

/**
 * Track curves: what differs first between two runs, in both of them around that moment.
 *
 * @param what such as {@code Joint 1}, for people
 * @param unit of the values: {@code °}, {@code mm}, or nothing for a level, which is 0 or 1
 * @param atS when they differ first, s since the switch-on
 * @param now of the new run
 * @param before of the earlier one
 */
public record TrackCurves(
    String what, String unit, double atS, List<Point> now, List<Point> before) {

  /** What holds from a time on, until that of the next point. */
  public record Point(double timeS, double value) {}

  /** Copies the points. */
  public TrackCurves {
    now = List.copyOf(now);
    before = List.copyOf(before);
  }
}
