package org.pendant.controller;

/** Pace of robot time compared with real time. */
public sealed interface Pace {
  /** As fast as a real controller. */
  Pace REAL_TIME = new Times(1);

  /** Robot time stands still. */
  record Paused() implements Pace {}

  /**
   * A multiple of real time.
   *
   * @param factor above 0 and at most 1000; 2 is twice as fast
   */
  record Times(double factor) implements Pace {
    /** Checks the factor. */
    public Times {
      if (!(factor > 0 && factor <= 1000)) {
        throw new IllegalArgumentException(
            "speed factor is " + factor + ", must be above 0 and at most 1000");
      }
    }
  }

  /** As fast as the processor goes. */
  record Unlimited() implements Pace {}
}
