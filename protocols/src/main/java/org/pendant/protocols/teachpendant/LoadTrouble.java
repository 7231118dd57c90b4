package org.pendant.protocols.teachpendant;

/** Load error: a file cannot be loaded. */
public final class LoadTrouble extends Exception {
  private static final long serialVersionUID = 1L;

  private final boolean missing;

  /**
   * A file that is not there, or not as it should be.
   *
   * @param missing whether there is no such file
   * @param message what, and what was expected
   */
  LoadTrouble(boolean missing, String message) {
    super(message);
    this.missing = missing;
  }

  /** Whether there is no such file; otherwise it is there and cannot be used. */
  public boolean missing() {
    return missing;
  }
}
