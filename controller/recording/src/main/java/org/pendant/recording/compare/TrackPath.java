package org.pendant.recording.compare;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Track path: the fewest places of a way that tell all others, which lie on straight lines between
 * them within bands. A place that was found once is never left out later, so that one look at each
 * is enough.
 */
final class TrackPath {
  private final double[] bands;
  private final List<Place> kept = new ArrayList<>();
  private final double[] lowest;
  private final double[] highest;
  private Place last;

  /** Where the way is in a frame. */
  static final class Place {
    private final long frame;
    private final double[] values;

    Place(long frame, double... values) {
      this.frame = frame;
      this.values = values.clone();
    }

    long frame() {
      return frame;
    }

    int size() {
      return values.length;
    }

    double value(int index) {
      return values[index];
    }

    private boolean sameAs(Place other) {
      return Arrays.equals(values, other.values);
    }
  }

  /**
   * An empty way.
   *
   * @param bands by how much each value may be off
   */
  TrackPath(double... bands) {
    this.bands = bands.clone();
    lowest = new double[bands.length];
    highest = new double[bands.length];
  }

  /** Takes the place of the next frame. */
  void take(Place next) {
    if (last == null) {
      keep(next);
    } else if (!follows(next)) {
      keep(last);
      narrow(next);
    } else {
      narrow(next);
    }
    last = next;
  }

  private void keep(Place place) {
    kept.add(place);
    Arrays.fill(lowest, Double.NEGATIVE_INFINITY);
    Arrays.fill(highest, Double.POSITIVE_INFINITY);
  }

  /** Whether the line to this place passes all places since the one kept last. */
  private boolean follows(Place next) {
    for (int i = 0; i < bands.length; i++) {
      double slope = slope(next, i, 0);
      if (!(slope >= lowest[i] && slope <= highest[i])) {
        return false;
      }
    }
    return true;
  }

  private void narrow(Place next) {
    for (int i = 0; i < bands.length; i++) {
      lowest[i] = Math.max(lowest[i], slope(next, i, -bands[i]));
      highest[i] = Math.min(highest[i], slope(next, i, bands[i]));
    }
  }

  private double slope(Place next, int index, double more) {
    Place from = kept.getLast();
    return (next.value(index) + more - from.value(index)) / (next.frame() - from.frame());
  }

  /** The places that are kept, the last one of the way among them. */
  List<Place> kept() {
    List<Place> all = new ArrayList<>(kept);
    if (last != null && last.frame() > all.getLast().frame() && !last.sameAs(all.getLast())) {
      all.add(last);
    }
    return all;
  }
}
