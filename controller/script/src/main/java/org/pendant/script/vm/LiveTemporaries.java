package org.pendant.script.vm;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import org.pendant.script.value.Registers;

/**
 * Live temporaries: finds the values that nobody will read any more, which expressions and calls
 * have left behind in the temporaries of frames under way. Which of them are still there differs
 * with the form that code ran in, so what a program takes must not depend on them.
 */
final class LiveTemporaries {
  private static final int POSE_ELEMENTS = 6;

  private record Place(ScriptFunction function, int pc, int slot) {}

  private final Program.Tables tables;

  /** What was found before: recursive functions are at the same place again and again. */
  private final Map<Place, Boolean> known = new HashMap<>();

  LiveTemporaries(Program.Tables tables) {
    this.tables = tables;
  }

  /** The slots with objects in temporaries of {@code thread} that are not read again. */
  BitSet dead(ScriptThread thread, Registers registers) {
    BitSet dead = new BitSet();
    for (int i = 0; i < thread.depth; i++) {
      ScriptFunction function = thread.functions[i];
      int base = thread.bases[i];
      boolean innermost = i == thread.depth - 1;
      int end = innermost ? function.slotCount() : thread.bases[i + 1] - base;
      for (int slot = function.variableCount(); slot < end; slot++) {
        if (registers.tags()[base + slot] == Registers.OBJECT
            && (slot == awaited(thread, i) || !live(new Place(function, next(thread, i), slot)))) {
          dead.set(base + slot);
        }
      }
    }
    return dead;
  }

  /** The slot of frame {@code index} that a result will come to; -1 for none. */
  private static int awaited(ScriptThread thread, int index) {
    if (index < thread.depth - 1) {
      return thread.results[index + 1];
    }
    return thread.state == ScriptThread.State.WAITING ? thread.waitResult : -1;
  }

  /** The instruction that frame {@code index} continues with. */
  private static int next(ScriptThread thread, int index) {
    // what it has begun is done again, with the same operands
    boolean again =
        index == thread.depth - 1 && thread.operation.isPresent() && !thread.interrupted;
    return thread.pcs[index] - (again ? 1 : 0);
  }

  /** Whether a value in a temporary is read from instruction {@code pc} on. */
  boolean hasTemporaries(ScriptFunction function, int pc) {
    for (int slot = function.variableCount(); slot < function.slotCount(); slot++) {
      if (live(new Place(function, pc, slot))) {
        return true;
      }
    }
    return false;
  }

  private boolean live(Place place) {
    return known.computeIfAbsent(place, p -> read(p.function().instructions(), p.pc(), p.slot()));
  }

  /** Whether some way from instruction {@code pc} on reads {@code slot} before it is written. */
  private boolean read(long[] instructions, int pc, int slot) {
    BitSet seen = new BitSet();
    Deque<Integer> open = new ArrayDeque<>();
    open.add(pc);
    while (!open.isEmpty()) {
      int at = open.removeLast();
      if (at >= instructions.length || seen.get(at)) {
        continue;
      }
      seen.set(at);
      long w = instructions[at];
      if (reads(w, slot)) {
        return true;
      }
      if (!writes(w, slot)) {
        follow(w, at, open);
      }
    }
    return false;
  }

  private static void follow(long w, int pc, Deque<Integer> open) {
    int target = Jumps.target(w, pc);
    if (target >= 0) {
      open.add(target);
    }
    if (Jumps.fallsThrough(w)) {
      open.add(pc + 1);
    }
  }

  private boolean reads(long w, int slot) {
    int a = Instruction.a(w);
    int b = Instruction.b(w);
    int c = Instruction.c(w);
    return switch (Instruction.operation(w)) {
      case Op.MOVE,
          Op.COPY,
          Op.ASSIGN,
          Op.ASSIGN_COPY,
          Op.NEGATE,
          Op.NOT,
          Op.GET_MEMBER,
          Op.OPEN_MEMBER ->
          is(b, slot);
      case Op.ADD,
          Op.SUBTRACT,
          Op.MULTIPLY,
          Op.DIVIDE,
          Op.MODULO,
          Op.EQUAL,
          Op.NOT_EQUAL,
          Op.LESS,
          Op.LESS_OR_EQUAL,
          Op.XOR,
          Op.GET_INDEX,
          Op.OPEN_INDEX ->
          is(b, slot) || is(c, slot);
      case Op.GET_INDEX_2 -> is(b, slot) || among(c, 2, slot);
      case Op.SET_INDEX -> is(a, slot) || is(b, slot) || is(c, slot);
      case Op.SET_INDEX_2 -> is(a, slot) || among(b, 2, slot) || is(c, slot);
      case Op.SET_MEMBER -> is(a, slot) || is(c, slot);
      case Op.JUMP_IF_GIVEN, Op.JUMP_IF_FALSE, Op.JUMP_IF_TRUE, Op.RETURN, Op.JOIN, Op.KILL ->
          is(a, slot);
      case Op.JUMP_IF_LESS,
          Op.JUMP_IF_LESS_OR_EQUAL,
          Op.JUMP_IF_NOT_LESS,
          Op.JUMP_IF_NOT_LESS_OR_EQUAL,
          Op.JUMP_IF_EQUAL,
          Op.JUMP_IF_NOT_EQUAL,
          Op.LOOP_IF_LESS,
          Op.LOOP_IF_LESS_OR_EQUAL ->
          is(a, slot) || is(b, slot);
      case Op.CALL -> among(c, tables.functions().get(b).parameterCount(), slot);
      case Op.CALL_BUILTIN ->
          among(c, tables.builtins().get(b).signature().parameters().size(), slot);
      case Op.CALL_METHOD, Op.CALL_PART_METHOD ->
          among(c, 1 + Methods.argumentCount(tables.names().get(Instruction.index(b))), slot);
      case Op.LIST -> among(c, b, slot);
      case Op.POSE -> among(c, POSE_ELEMENTS, slot);
      case Op.STRUCT -> among(c, tables.nameLists().get(Instruction.index(b)).size(), slot);
      default -> false;
    };
  }

  private static boolean writes(long w, int slot) {
    int a = Instruction.a(w);
    return switch (Instruction.operation(w)) {
      case Op.MOVE,
          Op.COPY,
          Op.UNSET,
          Op.ADD,
          Op.SUBTRACT,
          Op.MULTIPLY,
          Op.DIVIDE,
          Op.MODULO,
          Op.NEGATE,
          Op.EQUAL,
          Op.NOT_EQUAL,
          Op.LESS,
          Op.LESS_OR_EQUAL,
          Op.NOT,
          Op.XOR,
          Op.CALL_BUILTIN,
          Op.CALL_METHOD,
          Op.CALL_PART_METHOD,
          Op.GET_INDEX,
          Op.GET_INDEX_2,
          Op.GET_MEMBER,
          Op.LIST,
          Op.POSE,
          Op.STRUCT,
          Op.RUN,
          Op.OPEN_INDEX,
          Op.OPEN_MEMBER ->
          is(a, slot);
      // the function's own slots lie over the arguments and all behind them
      case Op.CALL -> is(a, slot) || slot >= Instruction.index(Instruction.c(w));
      default -> false;
    };
  }

  private static boolean is(int operand, int slot) {
    return Instruction.isLocal(operand) && Instruction.index(operand) == slot;
  }

  /** Whether {@code slot} is one of {@code count} from {@code first} on. */
  private static boolean among(int first, int count, int slot) {
    int from = Instruction.index(first);
    return slot >= from && slot < from + count;
  }
}
