package org.pendant.sweep.folder;

/** Sweep folder exception: what is wrong with a folder of results, for people; it is no fault. */
public final class SweepFolderException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * @param message what is wrong, and what would be right
   */
  public SweepFolderException(String message) {
    super(message, null, false, false);
  }
}
