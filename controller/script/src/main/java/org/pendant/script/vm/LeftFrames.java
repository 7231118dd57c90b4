package org.pendant.script.vm;

import java.util.Arrays;
import org.pendant.script.value.Registers;

/**
 * Left frames: the frames of {@link DirectCode} that cannot go on, the innermost first, until they
 * become call frames of the thread.
 */
final class LeftFrames {
  /** How the innermost frame continues: at a call, or where loops are left. */
  static final int IN_ANY_FORM = 0;

  /** The slice is used up. */
  static final int IN_NEXT_SLICE = 1;

  /** With an instruction that only the instruction loop can continue with. */
  static final int INTERPRETED = 2;

  /** Whether direct code is being left; a result that is no number can mean either. */
  boolean leaving;

  private int how;

  /** The instruction that the frame of a loop continues with. */
  private int loopPc;

  private int depth;
  private int[] frames = new int[0];
  private int size;
  private int[] slots = new int[0];
  private double[] numbers = new double[0];

  /** A call is not begun, since there is no room or no time for it. */
  void refuse() {
    leaving = true;
  }

  /** 1 if a frame inside of the one that asks was left, and 0 if its call was not begun. */
  int entered() {
    return Math.min(depth, 1);
  }

  /**
   * A frame of function {@code number} is left.
   *
   * @param pc before the instruction it continues with
   * @param how it continues if it is the innermost
   */
  void frame(int number, int pc, int how) {
    if (depth == 0) {
      this.how = how;
      leaving = true;
    }
    int at = 3 * depth++;
    if (at + 3 > frames.length) {
      frames = Arrays.copyOf(frames, 2 * (at + 3));
    }
    frames[at] = number;
    frames[at + 1] = pc;
    frames[at + 2] = size;
  }

  /** The frame of a loop is left, as {@link #frame}; it is one of the thread already. */
  void loop(int pc, int how) {
    loopPc = pc;
    if (depth == 0) {
      this.how = how;
    }
  }

  /** What slot {@code index} of the frame that was left last holds. */
  void slot(int index, int tag, double number) {
    if (size == numbers.length) {
      numbers = Arrays.copyOf(numbers, 2 * (size + 8));
      slots = Arrays.copyOf(slots, numbers.length);
    }
    slots[size] = index << Byte.SIZE | tag;
    numbers[size++] = number;
  }

  /**
   * Pushes the frames that the innermost frame of the thread, in a loop, has called.
   *
   * @return how the innermost continues
   */
  int pushAboveLoop(ScriptThread thread, ScriptFunction[] functions, Registers registers) {
    int top = thread.depth - 1;
    thread.pcs[top] = loopPc;
    leaving = false;
    if (depth == 0) {
      return how;
    }
    long call = thread.functions[top].instructions()[loopPc - 1];
    int first = thread.bases[top] + Instruction.index(Instruction.c(call));
    return push(thread, functions, registers, first, Instruction.index(Instruction.a(call)));
  }

  /**
   * Pushes the frames.
   *
   * @param first the first slot of the outermost
   * @param result where its caller wants the result
   * @return how the innermost continues
   */
  int push(
      ScriptThread thread, ScriptFunction[] functions, Registers registers, int first, int result) {
    int base = first;
    int target = result;
    int end = size;
    for (int at = 3 * (depth - 1); at >= 0; at -= 3) {
      ScriptFunction function = functions[frames[at]];
      int pc = frames[at + 1];
      thread.push(function, base, target);
      thread.pcs[thread.depth - 1] = pc;
      end = at == 3 * (depth - 1) ? size : frames[at + 5];
      for (int i = frames[at + 2]; i < end; i++) {
        int slot = base + (slots[i] >> Byte.SIZE);
        registers.tags()[slot] = (byte) slots[i];
        registers.numbers()[slot] = numbers[i];
      }
      if (at > 0) {
        long call = function.instructions()[pc - 1];
        base += Instruction.index(Instruction.c(call));
        target = Instruction.index(Instruction.a(call));
      }
    }
    depth = 0;
    size = 0;
    leaving = false;
    return how;
  }
}
