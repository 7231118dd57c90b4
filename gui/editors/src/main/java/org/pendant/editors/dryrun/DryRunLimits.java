package org.pendant.editors.dryrun;

import java.time.Duration;

/**
 * Dry run limits: when a dry run is given up.
 *
 * @param robotTime robot time
 * @param wallTime time of the computer
 */
public record DryRunLimits(Duration robotTime, Duration wallTime) {
  /** Enough for most programs that end. */
  public static final DryRunLimits STANDARD =
      new DryRunLimits(Duration.ofMinutes(5), Duration.ofSeconds(3));
}
