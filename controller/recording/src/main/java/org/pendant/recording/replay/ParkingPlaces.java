package org.pendant.recording.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;

/**
 * Parking places: where in a run {@link ParkedRuns} should stand, so that each moment that people
 * can look at has one close before it: around the moment that they look at, and at equal distances
 * all along what is recorded.
 */
final class ParkingPlaces {
  /**
   * The least distance of two places of a row, s: a way of half of it takes a tenth of a second.
   */
  private static final long DISTANCE_S = 60;

  /** Nearer to the newest frame it is not worth it, s. */
  private static final long NEAREST_S = 15;

  /** How many there are in a row; where more would be needed, the distance is twice as long. */
  private static final int ROW = 10;

  /** From how long before a moment that people look at a run is close enough, s. */
  private static final long CLOSE_S = 20;

  private static final long SHORT_S = 3;

  /** So many at most. */
  static final int MAX = ROW + 2;

  private final long second;

  /** Those of a controller, which has {@code second} frames a second. */
  ParkingPlaces(long second) {
    this.second = second;
  }

  /**
   * A place: any frame from one to another is good, and one that has to be led there goes to {@code
   * goal}.
   */
  record Place(long from, long to, long goal) {
    boolean fits(long frame) {
      return frame >= from && frame <= to;
    }
  }

  /**
   * Where runs should stand, those that matter most first. Places that a controller fits that was
   * just switched on are left out.
   *
   * @param oldest the first frame that people can look at
   * @param newest the last frame that can be repeated
   * @param looked the frame that people look at; empty for now
   */
  List<Place> of(long oldest, long newest, OptionalLong looked) {
    List<Place> places = new ArrayList<>();
    if (looked.isPresent()) {
      long frame = Math.min(looked.getAsLong(), newest);
      long close = CLOSE_S * second;
      add(places, frame - close, frame, frame - SHORT_S * second);
      // for another one from the same moment, and for those who look at what was before it
      add(places, frame - 4 * close, frame - close - 1, frame - 2 * close);
    }
    addRow(places, oldest, newest - NEAREST_S * second);
    return places;
  }

  /**
   * Multiples of a distance: those that are there stay where they are while the run goes on, and
   * where the distance doubles every other one does.
   */
  private void addRow(List<Place> places, long oldest, long newest) {
    long distance = DISTANCE_S * second;
    while (newest / distance - oldest / distance >= ROW) {
      distance *= 2;
    }
    for (long i = newest / distance; i >= Math.max(1, oldest / distance); i--) {
      add(places, i * distance - distance / 4, i * distance, i * distance);
    }
  }

  private static void add(List<Place> places, long from, long to, long goal) {
    if (from > 0) {
      places.add(new Place(from, to, goal));
    }
  }
}
