package org.pendant.testing.run;

import java.time.Duration;
import org.pendant.controller.ControllerOptions;

/**
 * Test settings: how tests are run.
 *
 * @param controller what each test's controller is switched on with
 * @param seed of the random order
 * @param jobs how many tests run at once, 1 or more
 * @param timeoutS how much robot time a test may take that does not say so itself
 * @param wallTimeout how long a test may take on this computer
 * @param failFast whether nothing more is run after the first red test; one runs at a time then
 */
public record TestSettings(
    ControllerOptions controller,
    long seed,
    int jobs,
    double timeoutS,
    Duration wallTimeout,
    boolean failFast) {
  /** How much robot time a test may take where nobody says otherwise, s. */
  public static final double STANDARD_TIMEOUT_S = 300;

  /** How long a test may take on the computer where nobody says otherwise. */
  public static final Duration STANDARD_WALL_TIMEOUT = Duration.ofSeconds(60);

  /** The same for a test that must do the same whatever the seed. */
  TestSettings withoutSeed() {
    return new TestSettings(controller.withSeed(0), 0, jobs, timeoutS, wallTimeout, failFast);
  }
}
