package org.pendant.desktop.debug;

import java.util.HashMap;
import java.util.Map;

/**
 * Value changes: which values have changed: against the stop before while a program is paused, and
 * for a moment after the change while it runs.
 */
final class ValueChanges {
  /** How long a change stays in sight while the program runs, ms. */
  static final long IN_SIGHT_MS = 700;

  private Map<ValueKey, String> before = Map.of();
  private Map<ValueKey, String> now = new HashMap<>();
  private final Map<ValueKey, Seen> live = new HashMap<>();
  private long newestMs = Long.MIN_VALUE / 2;

  /** What was seen last, and when it became so; at first it has not changed. */
  private record Seen(String text, long sinceMs) {}

  /** The program is paused anew: what is different from now has changed. */
  void stopped() {
    before = now;
    now = new HashMap<>();
  }

  /** Another program runs: nothing has changed yet. */
  void forgetLive() {
    live.clear();
    newestMs = Long.MIN_VALUE / 2;
  }

  /** A value of a program that is paused. */
  ValueRow.Change held(ValueKey key, String text) {
    now.put(key, text);
    String old = before.get(key);
    return old == null || old.equals(text) ? ValueRow.Change.NONE : ValueRow.Change.SINCE_STOP;
  }

  /** A value of a program that runs, at a time of any clock. */
  ValueRow.Change live(ValueKey key, String text, long nowMs) {
    Seen seen = live.get(key);
    if (seen == null) {
      live.put(key, new Seen(text, Long.MIN_VALUE / 2));
      return ValueRow.Change.NONE;
    }
    if (!seen.text().equals(text)) {
      live.put(key, new Seen(text, nowMs));
      newestMs = nowMs;
      return ValueRow.Change.JUST_NOW;
    }
    return nowMs - seen.sinceMs() < IN_SIGHT_MS ? ValueRow.Change.JUST_NOW : ValueRow.Change.NONE;
  }

  /** Whether a change was in sight the last time {@code beforeMs} that is not any more. */
  boolean fades(long beforeMs, long nowMs) {
    return beforeMs - newestMs < IN_SIGHT_MS || nowMs - newestMs < IN_SIGHT_MS;
  }
}
