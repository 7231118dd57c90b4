package org.pendant.script.vm;

import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Registers;
import org.pendant.script.value.Value;

/** Tag set: the tags of {@link Registers} that a slot may have, one bit each; 0 if unknown. */
final class TagSet {
  static final int INT = of(Registers.INT);
  static final int FLOAT = of(Registers.FLOAT);
  static final int NUMBER = INT | FLOAT;
  static final int BOOL = of(Registers.BOOL);
  static final int NONE = of(Registers.NONE);
  static final int OBJECT = of(Registers.OBJECT);
  static final int UNASSIGNED = of(Registers.UNASSIGNED);

  // objects of which more is known
  static final int INT_LIST = 64;
  static final int FLOAT_LIST = 128;
  static final int INT_MATRIX = 256;
  static final int FLOAT_MATRIX = 512;

  static final int LIST = INT_LIST | FLOAT_LIST;
  static final int MATRIX = INT_MATRIX | FLOAT_MATRIX;

  /** Every tag of a value that is no object. */
  static final int PLAIN = NUMBER | BOOL | NONE;

  /** A set of tags of registers fits in as many bits. */
  static final int BITS = 6;

  /** The largest set of tags of registers. */
  static final int MAX = (1 << BITS) - 1;

  private TagSet() {}

  static int of(int tag) {
    return tag == 0 ? 1 : tag << 1;
  }

  static int of(Value constant) {
    return of(
        switch (constant) {
          case IntValue i -> Registers.INT;
          case FloatValue f -> Registers.FLOAT;
          case BoolValue b -> Registers.BOOL;
          case NoneValue n -> Registers.NONE;
          default -> Registers.OBJECT;
        });
  }

  /** The tag in {@code slot}, of an object what is known of it. */
  static int in(Registers registers, int slot) {
    int tag = registers.tags()[slot];
    return tag == Registers.OBJECT ? object(registers.objects()[slot]) : of(tag);
  }

  private static int object(Value object) {
    if (object instanceof NumberList list) {
      return switch (list.tag()) {
        case Registers.INT -> INT_LIST;
        case Registers.FLOAT -> FLOAT_LIST;
        default -> OBJECT;
      };
    }
    if (object instanceof MatrixValue matrix) {
      return matrix.integers() ? INT_MATRIX : FLOAT_MATRIX;
    }
    return OBJECT;
  }

  /** The tag of the elements of a container. */
  static int element(int container) {
    return container == INT_LIST || container == INT_MATRIX ? INT : FLOAT;
  }

  /** Whether direct code may have written what has tags of {@code set}: it writes no objects. */
  static boolean mayBeWritten(int set) {
    return set != 0 && within(set, PLAIN | UNASSIGNED);
  }

  /** Whether there is one tag that it must be. */
  static boolean single(int set) {
    return Integer.bitCount(set) == 1;
  }

  /** The only tag of {@code set}. */
  static int tag(int set) {
    return set >> 1;
  }

  static boolean within(int set, int bounds) {
    return (set & ~bounds) == 0;
  }

  /**
   * The tags that a variable of {@code current} may have after an assignment of {@code value} that
   * is not refused.
   */
  static int assigned(int current, int value) {
    int plain = value & PLAIN;
    int kept = plain & current;
    int numbers = (current & NUMBER) != 0 ? plain & NUMBER : 0;
    return kept | numbers | ((current & UNASSIGNED) != 0 ? plain : 0);
  }

  /** Whether no assignment of {@code value} to a variable of {@code current} is refused. */
  static boolean assignable(int current, int value) {
    return within(value, PLAIN)
        && (within(current, UNASSIGNED)
            || (within(value, NUMBER) && within(current, NUMBER | UNASSIGNED))
            || (single(value) && within(current, value | UNASSIGNED)));
  }
}
