package org.pendant.script.vm;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.script.value.Registers;

/** Global tags: the {@link TagSet}s of global variables at some time. */
final class GlobalTags {
  private final int[] slots;
  private final int[] tags;

  /**
   * @param slots the static slots, ascending
   */
  GlobalTags(int[] slots, int[] tags) {
    this.slots = slots;
    this.tags = tags;
  }

  /** What the registers hold. */
  static GlobalTags in(Registers registers, int[] slots) {
    return new GlobalTags(
        slots, Arrays.stream(slots).map(slot -> TagSet.in(registers, slot)).toArray());
  }

  /** The static slots of the global variables that functions, and those they call, name. */
  static SortedSet<Integer> named(Program.Tables tables, Collection<Integer> functions) {
    SortedSet<Integer> named = new TreeSet<>();
    Set<Integer> known = new HashSet<>(functions);
    Deque<Integer> open = new ArrayDeque<>(known);
    while (!open.isEmpty() && known.size() <= DirectUnit.MAX_FORMS) {
      for (long w : tables.functions().get(open.remove()).instructions()) {
        for (int operand : LoopInstructions.operandsInFunction(w)) {
          if (!Instruction.isLocal(operand) && tables.constant(operand).isEmpty()) {
            named.add(operand);
          }
        }
        LoopInstructions.called(w, tables).filter(known::add).ifPresent(open::add);
      }
    }
    return named;
  }

  int[] slots() {
    return slots;
  }

  int[] tags() {
    return tags;
  }

  /** Whether the registers hold the same. */
  boolean are(Registers registers) {
    for (int i = 0; i < slots.length; i++) {
      if (tags[i] != TagSet.in(registers, slots[i])) {
        return false;
      }
    }
    return true;
  }
}
