package org.pendant.sweep.folder;

import java.util.Optional;

/** Sweep folder exception: what is wrong with a folder of results, for people; it is no fault. */
public final class SweepFolderException extends Exception {
  private static final long serialVersionUID = 1L;

  private final Earlier earlier;

  /** Results that are in a folder already, which whoever wants others must decide about. */
  public enum Earlier {
    /** Of any plan. */
    ANY,
    /** Of another plan, or of files that have changed since. */
    OTHER
  }

  /**
   * @param message what is wrong, and what would be right
   */
  public SweepFolderException(String message) {
    this(message, null);
  }

  /**
   * @param message as the command line says it
   * @param earlier the results that are in the way; null for none
   */
  SweepFolderException(String message, Earlier earlier) {
    super(message, null, false, false);
    this.earlier = earlier;
  }

  /** The results that are in the way: what to do about them depends on who is asked. */
  public Optional<Earlier> earlier() {
    return Optional.ofNullable(earlier);
  }
}
