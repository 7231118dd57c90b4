package org.pendant.controller.io;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Input watchdogs: check that clients continue to write inputs while a program runs (manual 18.41).
 * Every package with an input counts, also one that does not change its value. While the program is
 * paused no client is late: the time begins anew when it continues.
 *
 * <p>Belongs to the thread of the frame loop. Times are those of the controller, s.
 */
public final class InputWatchdogs {
  /** Less than this is rounding of times, s; a frame is much longer. */
  private static final double ROUNDING_S = 1e-6;

  private final Map<String, Watchdog> watchdogs = new LinkedHashMap<>();

  /**
   * An input that was not written in time.
   *
   * @param input its name, such as {@code input_int_register_0}
   * @param leastHz how often it must be written, Hz
   */
  public record Violation(String input, double leastHz, WatchdogAction action) {}

  private static final class Watchdog {
    private final Violation violation;
    private final boolean fallback;
    private double sinceS;
    private boolean reported;

    Watchdog(Violation violation, boolean fallback, double nowS) {
      this.violation = violation;
      this.fallback = fallback;
      sinceS = nowS;
    }

    void begin(double nowS) {
      sinceS = nowS;
      reported = false;
    }

    boolean late(double nowS) {
      return nowS - sinceS > 1 / violation.leastHz() + ROUNDING_S;
    }
  }

  /**
   * Watches an input from now on; takes the place of another watchdog of this input.
   *
   * @param leastHz how often it must be written, Hz, above 0
   */
  public void set(String input, double leastHz, WatchdogAction action, double nowS) {
    put(new Watchdog(new Violation(input, leastHz, action), false, nowS));
  }

  /** As {@link #set}, unless something is watched already. */
  public void setUnlessAny(String input, double leastHz, WatchdogAction action, double nowS) {
    if (watchdogs.isEmpty()) {
      put(new Watchdog(new Violation(input, leastHz, action), true, nowS));
    }
  }

  private void put(Watchdog watchdog) {
    watchdogs.put(watchdog.violation.input(), watchdog);
  }

  /** Ends what {@link #setUnlessAny} has begun. */
  public void removeUnasked() {
    watchdogs.values().removeIf(each -> each.fallback);
  }

  /** Ends all watching. */
  public void clear() {
    watchdogs.clear();
  }

  /** Inputs were written. */
  public void received(Set<String> inputs, double nowS) {
    for (Watchdog each : watchdogs.values()) {
      if (inputs.contains(each.violation.input())) {
        each.begin(nowS);
      }
    }
  }

  /**
   * What is late in this frame and was not before.
   *
   * @param running whether the program runs
   */
  public List<Violation> step(boolean running, double nowS) {
    if (watchdogs.isEmpty()) {
      return List.of();
    }
    List<Violation> violations = new ArrayList<>();
    for (Watchdog each : watchdogs.values()) {
      if (!running) {
        each.begin(nowS);
      } else if (!each.reported && each.late(nowS)) {
        each.reported = true;
        violations.add(each.violation);
      }
    }
    return violations;
  }
}
