package org.pendant.script.vm;

/**
 * Direct entry: {@link DirectCode} of a function for arguments and global variables of certain
 * tags.
 */
final class DirectEntry {
  /** Functions of more parameters are never called directly. */
  static final int MAX_PARAMETERS = Long.SIZE / TagSet.BITS;

  /** Ends of direct calls that are always allowed, and calls that another one is allowed for. */
  private static final int FREE_EXITS = 200;

  private static final int CALLS_PER_EXIT = 16;

  private final long key;
  private final GlobalTags globals;
  private final DirectCode code;
  private final int slotsLog2;
  private final DirectEntry next;

  /** Calls, and exits that were not the end of a slice; roughly where several machines count. */
  private long calls;

  private long exits;

  /**
   * @param key the {@link TagSet} of each argument, see {@link #key}
   * @param globals what the global variables are that it names
   * @param code null while there is none
   * @param slots most slots that a function of it has
   * @param next an older one
   */
  DirectEntry(long key, GlobalTags globals, DirectCode code, int slots, DirectEntry next) {
    this.key = key;
    this.globals = globals;
    this.code = code;
    this.next = next;
    slotsLog2 = Integer.SIZE - Integer.numberOfLeadingZeros(slots);
  }

  /** A key with one more argument behind others, {@code index} of them. */
  static long key(long key, int index, int tag) {
    return key | (long) TagSet.of(tag) << (index * TagSet.BITS);
  }

  /** The {@link TagSet} of each argument. */
  static int[] tags(long key, int count) {
    int[] tags = new int[count];
    for (int i = 0; i < count; i++) {
      tags[i] = (int) (key >> (i * TagSet.BITS)) & ((1 << TagSet.BITS) - 1);
    }
    return tags;
  }

  GlobalTags globals() {
    return globals;
  }

  long key() {
    return key;
  }

  DirectCode code() {
    return code;
  }

  DirectEntry next() {
    return next;
  }

  /** How many there are, older ones included. */
  int count() {
    return next == null ? 1 : 1 + next.count();
  }

  /** How deep calls may be before they could need more than {@code slots}. */
  int depth(int slots) {
    return (slots >> slotsLog2) - 1;
  }

  /** Counts a call; whether it is worth to make it. */
  boolean worthwhile() {
    calls++;
    return (exits - FREE_EXITS) * CALLS_PER_EXIT < calls;
  }

  /** Counts an exit before the end of the call and of the slice. */
  void exited() {
    exits++;
  }
}
