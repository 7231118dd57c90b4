package org.pendant.controller.box;

/** Light ring in the base: what it shows (manual 16.45 to 16.47). */
public sealed interface BaseLight {
  /** As the standard asks: it shows the mode and the stops of the robot. */
  Standard STANDARD = new Standard();

  /** Dark. */
  Off OFF = new Off();

  /** As IEC 60204-1 asks. */
  record Standard() implements BaseLight {}

  /** Dark. */
  record Off() implements BaseLight {}

  /**
   * One colour all around.
   *
   * @param red 0 to 255
   * @param green 0 to 255
   * @param blue 0 to 255
   */
  record Solid(int red, int green, int blue) implements BaseLight {}
}
