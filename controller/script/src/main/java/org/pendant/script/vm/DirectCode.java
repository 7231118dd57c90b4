package org.pendant.script.vm;

/**
 * Direct code: a function, and those it calls, as methods of the JVM that call each other directly,
 * keep plain values in the JVM's variables alone, and write neither call frames nor registers.
 *
 * <p>It counts what it takes of the slice as every other form does. Where it cannot go on, because
 * the slice is used up, a value is not of the kind it was made for, or the calls get too deep, each
 * of its methods notes its frame in {@link LeftFrames} and returns. The {@link Processor} makes
 * frames of them, and the other forms continue from there.
 */
abstract class DirectCode {
  /**
   * Calls the function.
   *
   * @param room how deep it may call others
   * @param first the slot of its first argument, whose tags are those it was made for
   * @param target the slot for its result
   * @return false when it was left before it returned
   */
  abstract boolean call(
      ScriptThread thread, int room, double[] numbers, byte[] tags, int first, int target);
}
