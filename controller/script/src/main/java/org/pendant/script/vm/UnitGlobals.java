package org.pendant.script.vm;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Set;

/**
 * Unit globals: the global variables of a {@link DirectUnit}, and the tags that they may have while
 * its code runs, which nothing else does then. Functions have them in the registers alone; a loop
 * keeps them in variables of its own, and writes those back for a call that functions share.
 */
final class UnitGlobals {
  private final int[] slots;
  private final int[] tags;
  private final BitSet shared = new BitSet();
  private final BitSet writtenByFunctions = new BitSet();
  private boolean changed;

  /**
   * @param before the tags that they have when the code is entered
   * @param shared those that functions name
   */
  UnitGlobals(GlobalTags before, Set<Integer> shared) {
    slots = before.slots();
    tags = before.tags().clone();
    for (int i = 0; i < slots.length; i++) {
      this.shared.set(i, shared.contains(slots[i]));
    }
  }

  int count() {
    return slots.length;
  }

  /** The static slot of global variable {@code index}. */
  int slot(int index) {
    return slots[index];
  }

  /** The number of the global variable that {@code operand} names; negative for any other. */
  int index(int operand) {
    return Arrays.binarySearch(slots, operand);
  }

  int tags(int index) {
    return tags[index];
  }

  /** Whether functions name it. */
  boolean shared(int index) {
    return shared.get(index);
  }

  boolean writtenByFunctions(int index) {
    return writtenByFunctions.get(index);
  }

  /** It may become what has tags of {@code written}. */
  void write(int index, int written, boolean byFunction) {
    changed |= (tags[index] | written) != tags[index];
    changed |= byFunction && !writtenByFunctions.get(index);
    tags[index] |= written;
    writtenByFunctions.set(index, byFunction || writtenByFunctions.get(index));
  }

  /** Whether more has become known since the last call of this. */
  boolean takeChanged() {
    boolean was = changed;
    changed = false;
    return was;
  }
}
