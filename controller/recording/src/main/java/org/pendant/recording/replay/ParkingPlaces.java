package org.pendant.recording.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;

/**
 * Parking places: where in a run {@link ParkedRuns} should stand, so that most moments have one
 * close before them: around the moment that people look at, and ever fewer the longer ago.
 */
final class ParkingPlaces {
  /** How far back from the newest frame the first place is, s; nearer it is hardly worth it. */
  private static final long NEAREST_S = 30;

  /** Each place behind the newest frame is so many times as far back as the one before. */
  private static final int FACTOR = 4;

  private static final int BEHIND = 4;

  /** From how long before a moment that people look at a run is close enough, s. */
  private static final long CLOSE_S = 20;

  private static final long SHORT_S = 3;

  /** So many at most. */
  static final int MAX = BEHIND + 2;

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
   * @param newest the last frame that can be repeated
   * @param looked the frame that people look at; empty for now
   */
  List<Place> of(long newest, OptionalLong looked) {
    List<Place> places = new ArrayList<>();
    if (looked.isPresent()) {
      long frame = Math.min(looked.getAsLong(), newest);
      long close = CLOSE_S * second;
      add(places, frame - close, frame, frame - SHORT_S * second);
      // for another one from the same moment, and for those who look at what was before it
      add(places, frame - 4 * close, frame - close - 1, frame - 2 * close);
    }
    long back = NEAREST_S * second;
    for (int i = 0; i < BEHIND; i++) {
      add(places, newest - FACTOR * back, newest - back, newest - back);
      back *= FACTOR;
    }
    return places;
  }

  private static void add(List<Place> places, long from, long to, long goal) {
    if (from > 0) {
      places.add(new Place(from, to, goal));
    }
  }
}
