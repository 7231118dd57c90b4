package org.pendant.models.arm;

/** How far a group of numbers in a description can be trusted. */
public enum Confidence {
  /** Two independent public sources agree. */
  VERIFIED,
  /** Taken over from a sister model. */
  ASSUMED,
  /** Estimated by us. */
  ESTIMATED,
  /** Not known. */
  MISSING
}
