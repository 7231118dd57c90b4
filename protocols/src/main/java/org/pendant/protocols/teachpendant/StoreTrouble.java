package org.pendant.protocols.teachpendant;

/** Store error: a program is neither taken nor given. */
public final class StoreTrouble extends Exception {
  private static final long serialVersionUID = 1L;

  private final Kind kind;

  /** What is in the way. */
  public enum Kind {
    /** There is a program of that name. */
    EXISTS,
    /** There is none. */
    MISSING,
    /** There is one that is no program of PolyScope X. */
    OTHER,
    /** It has a name that no program may have, or is none. */
    WRONG,
    /** There is no folder, or no room in it. */
    FULL,
    /** The disk refuses it. */
    FAILED
  }

  /**
   * Something is in the way.
   *
   * @param message what, and what would be right
   */
  StoreTrouble(Kind kind, String message) {
    super(message);
    this.kind = kind;
  }

  /** What is in the way. */
  public Kind kind() {
    return kind;
  }
}
