package org.pendant.controller.io;

/**
 * Tool pin mode: how an output pin of the tool connector drives what is connected to it (manual
 * 18.51).
 */
public enum ToolPinMode {
  /** NPN: pulls to ground when high. */
  SINKING(1),
  /** PNP: delivers current when high. */
  SOURCING(2),
  /** Does the one or the other. */
  PUSH_PULL(3);

  private final int number;

  ToolPinMode(int number) {
    this.number = number;
  }

  /** The mode that scripts and protocols call by {@code number}, 1 to 3. */
  public static ToolPinMode of(int number) {
    return values()[number - 1];
  }

  /** What scripts and protocols call it, 1 to 3. */
  public int number() {
    return number;
  }
}
