package org.pendant.desktop.editor.text;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * Trail: places that the user jumped away from, to go back to and forward again.
 *
 * @param <P> a place
 */
public final class Trail<P> {
  private static final int MOST = 100;

  private final Deque<P> behind = new ArrayDeque<>();
  private final Deque<P> ahead = new ArrayDeque<>();

  /** The user jumps away from {@code place}; what was ahead is forgotten. */
  public void left(P place) {
    if (!place.equals(behind.peek())) {
      push(behind, place);
    }
    ahead.clear();
  }

  /** Where to go back to from {@code now}. */
  public Optional<P> back(P now) {
    return go(behind, ahead, now);
  }

  /** Where to go forward to from {@code now}. */
  public Optional<P> forward(P now) {
    return go(ahead, behind, now);
  }

  private Optional<P> go(Deque<P> from, Deque<P> to, P now) {
    P place = from.poll();
    while (now.equals(place)) {
      place = from.poll();
    }
    if (place != null) {
      push(to, now);
    }
    return Optional.ofNullable(place);
  }

  private void push(Deque<P> places, P place) {
    places.push(place);
    if (places.size() > MOST) {
      places.removeLast();
    }
  }
}
