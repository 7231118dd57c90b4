package org.pendant.models.arm;

import java.util.Locale;

/** Confidence: how far a group of numbers in a description can be trusted. */
public enum Confidence {
  /** Two independent public sources agree. */
  VERIFIED,
  /** Measured by us on a public drawing or recording of this very model; one source. */
  MEASURED,
  /** Taken over from a measured part of the same size in another place or model. */
  DERIVED,
  /** Taken over from a sister model. */
  ASSUMED,
  /** Estimated by us. */
  ESTIMATED,
  /** Not known. */
  MISSING;

  /**
   * The constant that {@link #word} calls {@code word}.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static Confidence named(String word) {
    for (Confidence each : values()) {
      if (each.word().equals(word)) {
        return each;
      }
    }
    throw new IllegalArgumentException(
        "status is "
            + word
            + ", must be verified, measured, derived, assumed, estimated or missing");
  }

  /** The name in lower case, as files and people write it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Whether the numbers were taken from this very model: verified or measured. */
  public boolean ofThisModel() {
    return this == VERIFIED || this == MEASURED;
  }
}
