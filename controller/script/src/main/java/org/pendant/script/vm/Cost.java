package org.pendant.script.vm;

import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/**
 * Cost of instructions: what they take of a thread's slice, in nanoseconds of a usual computer.
 * Time is counted and not measured, so that every machine schedules alike; the numbers were
 * measured once, roughly.
 */
final class Cost {
  /** Instructions that may follow each other without being counted. */
  static final int MAX_STRETCH = 256;

  private static final int TURN_NS = 2;
  private static final int CALL_NS = 6;
  private static final int INSTRUCTION_NS = 1;

  /** A call of a built-in, beside what the built-in itself says that it takes. */
  static final int BUILTIN_NS = 25;

  /** Calls in a frame that ask for the robot's state, before they count as waiting for it. */
  private static final int FREE_QUESTIONS = 64;

  private static final int QUESTION_NS = 10_000;

  /** Starting a thread. */
  static final int THREAD_NS = 1000;

  /** Joining or killing a thread. */
  static final int HANDLE_NS = 200;

  /** An instruction that makes or changes a value that is no plain number. */
  static final int GENERAL_NS = 20;

  /** Linking a statement of interpreter mode into the program. */
  static final int LINE_NS = 30_000;

  /** A stretch of instructions. */
  static final int STRETCH_NS = MAX_STRETCH * INSTRUCTION_NS;

  private static final int ELEMENT_NS = 1;
  private static final int OBJECT_NS = 10;
  private static final int MEMBER_NS = 40;

  private Cost() {}

  /** A turn of a loop that jumps back over {@code instructions}. */
  static int turn(int instructions) {
    return TURN_NS + INSTRUCTION_NS * Math.min(instructions, MAX_STRETCH);
  }

  /** A call of a function. */
  static int call(int instructions) {
    return CALL_NS + INSTRUCTION_NS * Math.min(instructions, MAX_STRETCH);
  }

  /**
   * Asking for the robot's state beside the call, which stays the same within a frame: a loop that
   * does nothing but wait for it leaves the rest of the frame to others, as it learns nothing more.
   *
   * @param before questions of the thread in this frame
   */
  static int question(int before) {
    return before < FREE_QUESTIONS ? 0 : QUESTION_NS;
  }

  /** A change of {@code container}, whose elements are copied if others have them, too. */
  static int change(Value container) {
    // not a pattern switch: without C2 it takes longer than what is counted here
    if (container instanceof NumberList list) {
      return list.shared() ? ELEMENT_NS * list.capacity() : 0;
    }
    if (container instanceof ObjectList list) {
      return list.shared() ? ELEMENT_NS * list.capacity() : 0;
    }
    if (container instanceof MatrixValue matrix) {
      return matrix.shared() ? ELEMENT_NS * size(matrix) : 0;
    }
    return container instanceof StructValue struct && struct.shared()
        ? OBJECT_NS * struct.length()
        : 0;
  }

  /**
   * An assignment of {@code incoming} to a variable or part of one that holds {@code current};
   * nothing of plain numbers.
   */
  static int assign(Value current, Value incoming) {
    if (incoming instanceof StructValue struct) {
      return MEMBER_NS * struct.allMembers();
    }
    // classes first: to find that something does not have an interface takes much longer
    boolean lists = incoming instanceof NumberList || incoming instanceof ObjectList;
    return lists
            && incoming instanceof ListValue list
            && current instanceof ListValue old
            && old.capacity() != list.capacity()
        ? ELEMENT_NS * (old.capacity() + list.length())
        : 0;
  }

  /** Looking whether {@code element} has the type that a part of a container must have. */
  static int type(Value element) {
    return element instanceof StructValue struct ? MEMBER_NS * struct.allMembers() : 0;
  }

  /** Computing that many elements. */
  static long elements(int count) {
    return (long) ELEMENT_NS * count;
  }

  /** Copying that many bytes of text. */
  static int bytes(int count) {
    return count / 8;
  }

  /** A comparison of two values; none of plain numbers. */
  static int comparison(Value left, Value right) {
    if (left.sizeBytes() <= Double.BYTES || right.sizeBytes() <= Double.BYTES) {
      return 0;
    }
    return (int) Math.min(Integer.MAX_VALUE / 4, Math.min(left.sizeBytes(), right.sizeBytes()) / 8);
  }

  /** Going once through the parts of {@code value}. */
  static int elements(Value value) {
    return switch (value) {
      case ListValue list -> list.length();
      case MatrixValue matrix -> size(matrix);
      case StringValue text -> text.length() / 8;
      case StructValue struct -> struct.length();
      default -> 1;
    };
  }

  private static int size(MatrixValue matrix) {
    return matrix.rows() * matrix.columns();
  }
}
