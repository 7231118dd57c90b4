package org.pendant.recording.whatif;

import java.time.Duration;

/**
 * Variant limits: when a variant is ended although its program runs on.
 *
 * @param robotTime how much robot time passes from the moment on
 * @param wallTime how long the computer works at it from there
 */
public record VariantLimits(Duration robotTime, Duration wallTime) {
  /** Ten minutes of robot time, and three of the computer's. */
  public static final VariantLimits STANDARD =
      new VariantLimits(Duration.ofMinutes(10), Duration.ofMinutes(3));
}
