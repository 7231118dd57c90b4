package org.pendant.script.vm;

import org.pendant.script.value.Value;

/**
 * Loop code: a loop, and the functions that it calls, as {@link DirectCode} is: its variables are
 * loaded when it is entered and written back when it is left, wherever that is.
 */
abstract class LoopCode {
  /**
   * Goes on with the loop where a turn begins; {@link LeftFrames} tells where it was left.
   *
   * @param room how deep it may call others
   * @param base the first slot of the function's frame, whose variables have the tags it was made
   *     for
   */
  abstract void run(
      ScriptThread thread, int room, double[] numbers, byte[] tags, Value[] objects, int base);

  /** Writes a slot back. */
  static void store(double[] numbers, byte[] tags, int slot, double number, int tag) {
    numbers[slot] = number;
    tags[slot] = (byte) tag;
  }
}
