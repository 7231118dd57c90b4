package org.pendant.script.vm;

import java.util.Arrays;

/**
 * Stack mark: which calls a thread was in at some moment, to find out later which of them are left.
 */
public final class StackMark {
  private final int[] callers;

  private StackMark(int[] callers) {
    this.callers = callers;
  }

  static StackMark of(ScriptThread thread) {
    return new StackMark(Arrays.copyOf(thread.pcs, thread.depth));
  }

  /** How many calls there were. */
  public int depth() {
    return callers.length;
  }

  /**
   * The depth of the innermost call of {@code thread} if it was there already when this was made, 0
   * for a newer one. A call is known by the place it was made from: while it lasts, its caller
   * stands there.
   */
  int depthOf(ScriptThread thread) {
    int depth = thread.depth;
    boolean known =
        depth <= callers.length && (depth == 1 || callers[depth - 2] == thread.pcs[depth - 2]);
    return known ? depth : 0;
  }
}
