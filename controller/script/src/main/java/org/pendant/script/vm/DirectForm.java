package org.pendant.script.vm;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Optional;
import org.pendant.script.value.Registers;

/**
 * Direct form: one function for arguments of known tags, or a loop for variables of known tags, and
 * what tags its slots may have before each instruction. An instruction that needs anything but
 * plain values, or a loop the elements of lists and matrices, cannot be done in this form and ends
 * it.
 *
 * <p>Global variables have slots behind those of the function.
 */
final class DirectForm {
  private final ScriptFunction function;
  private final int number;
  private final int[] parameters;
  private final Optional<LoopRegion> loop;

  /** The tags of the slots before its first instruction. */
  private final int[] given;

  private final DirectUnit unit;
  private final Program.Tables tables;
  private final long[] instructions;

  /** Before each instruction the {@link TagSet} of each slot; null for one that is not reached. */
  private int[][] states = new int[0][];

  private int result;

  /**
   * @param number of the function in its program
   * @param parameters the {@link TagSet} of each argument
   */
  DirectForm(DirectUnit unit, Program.Tables tables, int number, int[] parameters) {
    this.unit = unit;
    this.tables = tables;
    this.number = number;
    this.parameters = parameters;
    loop = Optional.empty();
    function = tables.functions().get(number);
    instructions = function.instructions();
    given = new int[function.slotCount() + unit.globals().count()];
    Arrays.fill(given, 0, function.variableCount(), TagSet.UNASSIGNED);
    System.arraycopy(parameters, 0, given, 0, parameters.length);
  }

  /**
   * @param tags of the loop's variables
   */
  DirectForm(DirectUnit unit, Program.Tables tables, LoopRegion loop, int[] tags) {
    this.unit = unit;
    this.tables = tables;
    this.loop = Optional.of(loop);
    number = -1;
    parameters = new int[0];
    function = loop.function();
    instructions = function.instructions();
    given = loop.state(tags);
  }

  ScriptFunction function() {
    return function;
  }

  int number() {
    return number;
  }

  /** The loop that this is a form of; empty for that of a function. */
  Optional<LoopRegion> loop() {
    return loop;
  }

  /** The tags of the slots before the first instruction. */
  int[] given() {
    return given;
  }

  /** Whether instruction {@code pc} belongs to it. */
  boolean contains(int pc) {
    return loop.isEmpty() || loop.get().contains(pc);
  }

  int parameterCount() {
    return parameters.length;
  }

  int parameter(int index) {
    return parameters[index];
  }

  /** The tags of what it returns; 0 when it does not. */
  int result() {
    return result;
  }

  /** The tags of the slots before instruction {@code pc}; null when that is not reached. */
  int[] state(int pc) {
    return states[pc];
  }

  boolean is(int number, int[] parameters) {
    return this.number == number && Arrays.equals(this.parameters, parameters);
  }

  /** Finds all tags anew with what is known of other functions; whether the result has others. */
  boolean flow() {
    states = new int[instructions.length][];
    int before = result;
    Deque<Integer> open = new ArrayDeque<>();
    settleGlobals(given);
    reach(loop.map(LoopRegion::head).orElse(0), given, open);
    while (!open.isEmpty()) {
      int pc = open.removeLast();
      follow(pc, states[pc], open);
    }
    return result != before;
  }

  private void follow(int pc, int[] state, Deque<Integer> open) {
    int[] after = after(pc, state);
    if (after == null) {
      return;
    }
    long w = instructions[pc];
    int target = Jumps.target(w, pc);
    switch (Instruction.operation(w)) {
      case Op.JUMP_IF_GIVEN -> {
        int argument = state[slot(Instruction.a(w))];
        if ((argument & ~TagSet.UNASSIGNED) != 0) {
          reach(target, after, open);
        }
        if ((argument & TagSet.UNASSIGNED) != 0) {
          reach(pc + 1, after, open);
        }
      }
      case Op.RETURN -> result |= tags(Instruction.a(w), state) & TagSet.PLAIN;
      case Op.RETURN_NONE -> result |= TagSet.NONE;
      default -> {
        if (target >= 0) {
          reach(target, after, open);
        }
        if (Jumps.fallsThrough(w)) {
          reach(pc + 1, after, open);
        }
      }
    }
  }

  private void reach(int pc, int[] incoming, Deque<Integer> open) {
    if (!contains(pc)) {
      return;
    }
    int[] known = states[pc];
    if (known == null) {
      states[pc] = incoming.clone();
      settleGlobals(states[pc]);
      open.add(pc);
      return;
    }
    boolean changed = false;
    for (int i = 0; i < (loop.isPresent() ? known.length : function.slotCount()); i++) {
      // what only one of the ways has set is a temporary that nobody reads any more
      int both = known[i] == 0 || incoming[i] == 0 ? 0 : known[i] | incoming[i];
      changed |= both != known[i];
      known[i] = both;
    }
    if (changed) {
      open.add(pc);
    }
  }

  /** The global variables of a function have any of their tags anywhere. */
  private void settleGlobals(int[] state) {
    for (int i = function.slotCount(); loop.isEmpty() && i < state.length; i++) {
      state[i] = unit.globals().tags(global(i));
    }
  }

  /** The number of the global variable that {@code slot} is for; negative for any other. */
  int global(int slot) {
    return slot - function.slotCount();
  }

  /** The slot of {@code operand}; -1 if that is a constant or not to be had in this form. */
  int slot(int operand) {
    if (Instruction.isLocal(operand)) {
      return Instruction.index(operand);
    }
    int global = unit.globals().index(operand);
    boolean had = global >= 0 && (loop.isPresent() || unit.globals().shared(global));
    return !had ? -1 : function.slotCount() + global;
  }

  /** The tags that {@code operand} may have; 0 when they are not known. */
  int tags(int operand, int[] state) {
    int slot = slot(operand);
    return slot >= 0 ? state[slot] : tables.constant(operand).map(TagSet::of).orElse(0);
  }

  boolean isVariable(int operand) {
    return !Instruction.isLocal(operand) || Instruction.index(operand) < function.variableCount();
  }

  /** The form that the call {@code w} enters; null when it cannot be done in this form. */
  DirectForm callee(long w, int[] state) {
    int callee = Instruction.b(w);
    if (callee >= tables.functions().size()) {
      return null;
    }
    int first = Instruction.index(Instruction.c(w));
    int count = tables.functions().get(callee).parameterCount();
    int[] arguments = Arrays.copyOfRange(state, first, first + count);
    return Arrays.stream(arguments).anyMatch(tags -> tags == 0 || tags > TagSet.MAX)
        ? null
        : unit.form(callee, arguments);
  }

  /**
   * The tags after instruction {@code pc}, on every way that leads on from it; null when it is
   * never done in this form.
   */
  int[] after(int pc, int[] state) {
    long w = instructions[pc];
    int a = Instruction.a(w);
    int b = Instruction.b(w);
    int c = Instruction.c(w);
    return switch (Instruction.operation(w)) {
      case Op.MOVE, Op.COPY -> with(state, a, tags(b, state) & TagSet.PLAIN);
      case Op.UNSET -> with(state, a, TagSet.UNASSIGNED);
      case Op.ASSIGN, Op.ASSIGN_COPY ->
          with(state, a, TagSet.assigned(tags(a, state), tags(b, state)));
      case Op.ADD, Op.SUBTRACT, Op.MULTIPLY ->
          withNumber(state, a, numbers(tags(b, state), tags(c, state)));
      case Op.DIVIDE ->
          withNumber(state, a, numbers(tags(b, state), tags(c, state)) == 0 ? 0 : TagSet.FLOAT);
      case Op.MODULO -> withNumber(state, a, tags(b, state) & tags(c, state) & TagSet.INT);
      case Op.NEGATE -> withNumber(state, a, tags(b, state) & TagSet.NUMBER);
      case Op.EQUAL, Op.NOT_EQUAL ->
          with(state, a, comparable(tags(b, state), tags(c, state)) ? TagSet.BOOL : 0);
      case Op.LESS, Op.LESS_OR_EQUAL ->
          with(state, a, numbers(tags(b, state), tags(c, state)) == 0 ? 0 : TagSet.BOOL);
      case Op.NOT -> with(state, a, hasTruth(tags(b, state)) ? TagSet.BOOL : 0);
      case Op.GET_INDEX -> withNumber(state, a, element(b, TagSet.LIST, state, c));
      case Op.GET_INDEX_2 -> withNumber(state, a, element(b, TagSet.MATRIX, state, c, c + 1));
      case Op.SET_INDEX -> takes(element(a, TagSet.LIST, state, b), tags(c, state)) ? state : null;
      case Op.SET_INDEX_2 ->
          takes(element(a, TagSet.MATRIX, state, b, b + 1), tags(c, state)) ? state : null;
      case Op.JUMP_IF_GIVEN, Op.JUMP, Op.LOOP, Op.STRETCH, Op.MARK -> state;
      case Op.RETURN_NONE -> loop.isEmpty() ? state : null;
      case Op.JUMP_IF_FALSE, Op.JUMP_IF_TRUE -> hasTruth(tags(a, state)) ? state : null;
      case Op.JUMP_IF_EQUAL, Op.JUMP_IF_NOT_EQUAL ->
          comparable(tags(a, state), tags(b, state)) ? state : null;
      case Op.JUMP_IF_LESS,
          Op.JUMP_IF_LESS_OR_EQUAL,
          Op.JUMP_IF_NOT_LESS,
          Op.JUMP_IF_NOT_LESS_OR_EQUAL,
          Op.LOOP_IF_LESS,
          Op.LOOP_IF_LESS_OR_EQUAL ->
          numbers(tags(a, state), tags(b, state)) == 0 ? null : state;
      case Op.RETURN -> loop.isPresent() || (tags(a, state) & TagSet.PLAIN) == 0 ? null : state;
      case Op.CALL -> {
        DirectForm callee = callee(w, state);
        if (callee == null || callee.result == 0) {
          yield null;
        }
        yield called(w, state, callee.result);
      }
      default -> null;
    };
  }

  /** The tag of the elements of a container; 0 if it has none at what may be such indices. */
  private int element(int container, int kinds, int[] state, int... indices) {
    int tags = tags(container, state) & kinds;
    boolean ints = Arrays.stream(indices).allMatch(i -> (tags(i, state) & TagSet.INT) != 0);
    return tags == 0 || !ints ? 0 : TagSet.element(tags);
  }

  /** Whether elements of such a tag may become what has {@code tags}. */
  private static boolean takes(int element, int tags) {
    return (tags & (element == TagSet.FLOAT ? TagSet.NUMBER : element)) != 0;
  }

  /** After a call nothing is left of the arguments. */
  private int[] called(long w, int[] state, int result) {
    int[] after = state.clone();
    Arrays.fill(after, Instruction.index(Instruction.c(w)), function.slotCount(), 0);
    after[Instruction.index(Instruction.a(w))] = result;
    for (int i = function.slotCount(); i < after.length; i++) {
      if (unit.globals().writtenByFunctions(global(i))) {
        after[i] = unit.globals().tags(global(i));
      }
    }
    return after;
  }

  private int[] with(int[] state, int target, int tags) {
    int slot = slot(target);
    if (tags == 0 || slot < 0) {
      return null;
    }
    if (global(slot) >= 0) {
      unit.globals().write(global(slot), tags, loop.isEmpty());
    }
    int[] after = state.clone();
    after[slot] = tags;
    return after;
  }

  /** A number is stored into a variable as it is unless that is of another kind. */
  private int[] withNumber(int[] state, int target, int tags) {
    boolean refused =
        isVariable(target) && (tags(target, state) & (TagSet.NUMBER | TagSet.UNASSIGNED)) == 0;
    return refused ? null : with(state, target, tags);
  }

  /** The tags of a sum; 0 when there is none. */
  static int numbers(int x, int y) {
    int left = x & TagSet.NUMBER;
    int right = y & TagSet.NUMBER;
    if (left == 0 || right == 0) {
      return 0;
    }
    if (left == TagSet.FLOAT || right == TagSet.FLOAT) {
      return TagSet.FLOAT;
    }
    return left | right;
  }

  /** Whether two values may be equal or not as their numbers are. */
  static boolean comparable(int x, int y) {
    return numbers(x, y) != 0 || (x == TagSet.BOOL && y == TagSet.BOOL);
  }

  private static boolean hasTruth(int tags) {
    return (tags & (TagSet.NUMBER | TagSet.BOOL)) != 0;
  }

  /** The number of a constant that is a number or bool. */
  double constant(int operand) {
    Registers one = new Registers(1);
    one.set(0, tables.constant(operand).orElseThrow());
    return one.numbers()[0];
  }
}
