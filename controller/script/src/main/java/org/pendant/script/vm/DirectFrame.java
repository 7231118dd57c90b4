package org.pendant.script.vm;

/** Direct frame: how a method of direct code takes over a frame, and how it gives it up. */
interface DirectFrame {
  /** Writes what is done before the first instruction. */
  void begin();

  /**
   * Writes how the frame is left as the variables for the instruction and how say.
   *
   * @param state the {@link TagSet} of each slot
   */
  void leave(int[] state);
}
