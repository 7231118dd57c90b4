package org.pendant.testing.remote;

/** Target trouble: a target cannot be reached, is lost, or does not do as it must. */
public final class TargetTrouble extends Exception {
  private static final long serialVersionUID = 1L;

  /** For people: what is wrong, and what they can do about it. */
  public TargetTrouble(String message) {
    super(message);
  }
}
