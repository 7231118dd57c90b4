package org.pendant.script.vm;

import org.pendant.script.value.Registers;

/** Loop entry: {@link LoopCode} of a loop for variables of certain tags. */
final class LoopEntry {
  /** Times that it is entered before it is known whether that is worth it. */
  private static final int TRIALS = 64;

  /** To enter and leave takes as long as this much of what a loop does otherwise. */
  private static final int MIN_NS = 400;

  /**
   * @param slotsLog2 of more slots than any function of it has
   */
  private record Made(LoopCode code, int slotsLog2) {}

  private final LoopRegion region;
  private final int[] tags;
  private final LoopEntry next;

  // Not volatile, as the translation of a function is not: what is in it never changes.
  private Made made;

  /** Times entered, and what was counted inside; roughly where several machines count. */
  private long runs;

  private long spentNs;

  /**
   * No code yet.
   *
   * @param tags of the region's variables
   * @param next an older one
   */
  LoopEntry(LoopRegion region, int[] tags, LoopEntry next) {
    this.region = region;
    this.tags = tags;
    this.next = next;
  }

  LoopRegion region() {
    return region;
  }

  int[] tags() {
    return tags;
  }

  LoopEntry next() {
    return next;
  }

  /** How many there are, older ones included. */
  int count() {
    return next == null ? 1 : 1 + next.count();
  }

  /** Whether it is for a turn at {@code pc} with such variables in the registers. */
  boolean suits(int pc, Registers registers, int base) {
    return region.head() == pc && region.have(tags, registers, base);
  }

  /**
   * @param slots most slots that a function of it has
   */
  void install(LoopCode code, int slots) {
    made = new Made(code, Integer.SIZE - Integer.numberOfLeadingZeros(slots));
  }

  /** Whether there is code, which is not left too soon each time. */
  boolean ready() {
    return made != null && (runs < TRIALS || spentNs >= runs * MIN_NS);
  }

  /** What to enter when it is ready. */
  LoopCode code() {
    return made.code();
  }

  /** Counts that it was entered, and what that took of the slice. */
  void ran(int ns) {
    runs++;
    spentNs += ns;
  }

  /** How deep calls may be before they could need more than {@code slots}. */
  int depth(int slots) {
    return (slots >> made.slotsLog2()) - 1;
  }
}
