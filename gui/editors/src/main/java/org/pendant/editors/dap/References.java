package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.HashMap;
import java.util.Map;
import org.pendant.editors.dap.look.Branch;

/**
 * References: the numbers by which a client names calls and values of a stopped program. They hold
 * until it goes on, and never mean anything else.
 */
final class References {
  /** Numbers that are given out between two stops. */
  private static final int MOST = 100_000;

  private final Map<Integer, Frame> frames = new HashMap<>();
  private final Map<Integer, Owned> branches = new HashMap<>();
  private int last = DebuggedText.GENERATED;

  /**
   * A call.
   *
   * @param thread of it
   * @param depth of it, 1 for the outermost
   */
  record Frame(int thread, int depth) {}

  /**
   * Parts of a value, or variables.
   *
   * @param frame the call in which they were seen
   */
  record Owned(Branch branch, Frame frame) {}

  private int next() {
    if (frames.size() + branches.size() >= MOST) {
      throw Refusals.of(text("tooManyValues", MOST));
    }
    return ++last;
  }

  /** A number for a call. */
  int of(Frame frame) {
    int number = next();
    frames.put(number, frame);
    return number;
  }

  /** A number for parts. */
  int of(Branch branch, Frame frame) {
    int number = next();
    branches.put(number, new Owned(branch, frame));
    return number;
  }

  /** The call of a number. */
  Frame frame(int number) {
    Frame frame = frames.get(number);
    if (frame == null) {
      throw Refusals.of(text("noSuchCall", number));
    }
    return frame;
  }

  /** The parts of a number. */
  Owned branch(int number) {
    Owned branch = branches.get(number);
    if (branch == null) {
      throw Refusals.of(text("noSuchVariables", number));
    }
    return branch;
  }

  /** The program goes on: none of them holds any more. */
  void clear() {
    frames.clear();
    branches.clear();
  }
}
