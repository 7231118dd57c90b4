package org.pendant.protocols.wire;

/** Direction in which bytes go. */
public enum Direction {
  /** From a client to a port. */
  IN("in"),

  /** From a port to a client. */
  OUT("out");

  private final String word;

  Direction(String word) {
    this.word = word;
  }

  /** In files and on screens. */
  public String word() {
    return word;
  }
}
