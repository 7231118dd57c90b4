package org.pendant.controller.device.gripper;

/**
 * Finger space: what is in the way of the fingers of a gripper. A part of a given width is one;
 * bodies of the cell may be another.
 */
public interface FingerSpace {
  /** Nothing is in the way. */
  FingerSpace FREE = new FingerSpace() {};

  /**
   * The opening at which fingers that close from here meet something.
   *
   * @param openingM how far they are open
   * @param forceN how hard they press
   * @return m, at most {@code openingM}; 0 where nothing is between them
   */
  default double closesToM(double openingM, double forceN) {
    return 0;
  }

  /**
   * The opening at which fingers that open from here meet something, such as the walls of a part
   * that they hold from the inside.
   *
   * @param openingM how far they are open
   * @param forceN how hard they press
   * @return m, at least {@code openingM}; infinity where nothing is around them
   */
  default double opensToM(double openingM, double forceN) {
    return Double.POSITIVE_INFINITY;
  }

  /** The fingers are where they are now, and press that hard on what they have met; each frame. */
  default void press(double openingM, double forceN) {}
}
