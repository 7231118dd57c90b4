package org.pendant.controller.eip;

import java.util.Optional;
import org.pendant.controller.io.WatchdogAction;

/**
 * Assembly watchdog: checks that the scanner continues to write an assembly while the program runs
 * (manual 21.3.8). While the program is paused no client is late: the time begins anew when it
 * continues.
 */
public final class AssemblyWatchdog {
  /** Less than this is rounding of times, s; a frame is much longer. */
  private static final double ROUNDING_S = 1e-6;

  private final Violation violation;
  private boolean active = true;
  private boolean reported;
  private double sinceS;

  /**
   * An assembly that was not written in time.
   *
   * @param leastHz how often it must be written, Hz
   */
  public record Violation(int instance, double leastHz, WatchdogAction action) {}

  AssemblyWatchdog(Violation violation, double nowS) {
    this.violation = violation;
    sinceS = nowS;
  }

  void begin(double nowS) {
    sinceS = nowS;
    reported = false;
  }

  void start(double nowS) {
    active = true;
    begin(nowS);
  }

  void stop() {
    active = false;
  }

  Optional<Violation> step(boolean running, double nowS) {
    if (!running) {
      begin(nowS);
    } else if (active && !reported && nowS - sinceS > 1 / violation.leastHz() + ROUNDING_S) {
      reported = true;
      return Optional.of(violation);
    }
    return Optional.empty();
  }
}
