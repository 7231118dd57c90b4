package org.pendant.script.vm;

/**
 * Operations of the machine. Operands a, b and c are explained beside each; "slot" is a value's
 * place, "args" the first of consecutive local slots.
 */
final class Op {
  private Op() {}

  /** a := b, without a copy; for temporaries and arguments that are only read. */
  static final int MOVE = 0;

  /** a := copy of b; for temporaries. */
  static final int COPY = 1;

  /** Variable a := b with its type kept; b is fresh. */
  static final int ASSIGN = 2;

  /** Variable a := copy of b with its type kept. */
  static final int ASSIGN_COPY = 3;

  /** Local a has no value: an argument left out. */
  static final int UNSET = 4;

  static final int ADD = 5;
  static final int SUBTRACT = 6;
  static final int MULTIPLY = 7;
  static final int DIVIDE = 8;
  static final int MODULO = 9;
  static final int NEGATE = 10;

  /** a := b == c, and so on; a is a temporary. */
  static final int EQUAL = 11;

  static final int NOT_EQUAL = 12;
  static final int LESS = 13;
  static final int LESS_OR_EQUAL = 14;
  static final int NOT = 15;
  static final int XOR = 16;

  /** Jumps by the distance when parameter a was given. */
  static final int JUMP_IF_GIVEN = 17;

  /** Jumps by the distance. */
  static final int JUMP = 18;

  /**
   * Jumps back by the distance and counts one turn, see {@link Cost#turn}; a of the instructions
   * are free.
   */
  static final int LOOP = 19;

  /** Jumps when a is false or true. */
  static final int JUMP_IF_FALSE = 20;

  static final int JUMP_IF_TRUE = 21;

  /** Jumps by distance c (18 bits) when the comparison of a and b holds. */
  static final int JUMP_IF_LESS = 22;

  static final int JUMP_IF_LESS_OR_EQUAL = 23;
  static final int JUMP_IF_NOT_LESS = 24;
  static final int JUMP_IF_NOT_LESS_OR_EQUAL = 25;
  static final int JUMP_IF_EQUAL = 26;
  static final int JUMP_IF_NOT_EQUAL = 27;

  /** As the ones above, backwards at the end of a loop: count one turn. */
  static final int LOOP_IF_LESS = 28;

  static final int LOOP_IF_LESS_OR_EQUAL = 29;

  /** a := result of function b with args c; a is a temporary. */
  static final int CALL = 30;

  /** a := result of built-in b with args c; a is a temporary. */
  static final int CALL_BUILTIN = 31;

  /** a := result of method b with args c, the receiver first. */
  static final int CALL_METHOD = 32;

  /** Returns a from the function. */
  static final int RETURN = 33;

  static final int RETURN_NONE = 34;

  /** a := b[c]. */
  static final int GET_INDEX = 35;

  /** a := b[c, c+1]. */
  static final int GET_INDEX_2 = 36;

  /** a[b] := c, which is fresh. */
  static final int SET_INDEX = 37;

  /** a[b, b+1] := c. */
  static final int SET_INDEX_2 = 38;

  /** a := b.name c. */
  static final int GET_MEMBER = 39;

  /** a.name b := c, which is fresh. */
  static final int SET_MEMBER = 40;

  /** a := list of b elements from args c. */
  static final int LIST = 41;

  /** a := pose of the six numbers from args c. */
  static final int POSE = 42;

  /** a := struct with names b and members from args c. */
  static final int STRUCT = 43;

  /** a := handle of a new thread that runs function b. */
  static final int RUN = 44;

  /** Waits for thread a. */
  static final int JOIN = 45;

  static final int KILL = 46;
  static final int ENTER_CRITICAL = 47;
  static final int EXIT_CRITICAL = 48;
  static final int HALT = 49;
  static final int PAUSE = 50;

  /** Ends an interpreted statement: back to interpreter mode. */
  static final int INTERPRETED = 51;

  /** Stands in place of a statement's first instruction where a debugger wants to know of it. */
  static final int TRAP = 52;

  /** a := b[c], which is changed next: a container that only b has. */
  static final int OPEN_INDEX = 53;

  /** a := b.name c, which is changed next: a container that only b has. */
  static final int OPEN_MEMBER = 54;

  /** Counts a stretch of instructions without a turn or call. */
  static final int STRETCH = 55;

  /** Fails: name b tells which arguments a call lacks. */
  static final int MISSING = 57;

  /** Marks coverage slot, which stands in place of the distance of a jump, as reached; is free. */
  static final int MARK = 58;

  /** As {@link #CALL_METHOD}, of a part that was opened before: no thread comes in between. */
  static final int CALL_PART_METHOD = 56;
}
