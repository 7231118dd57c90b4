package org.pendant.script.vm;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.script.value.Registers;

/**
 * Loop region: the outermost loop of a function around the place where a turn begins, with the
 * variables that its instructions name.
 */
final class LoopRegion {
  private final ScriptFunction function;
  private final int head;
  private final int first;
  private final int last;

  /** The operands of local and then of global variables that it names. */
  private final int[] variables;

  /** The static slots of the global ones. */
  private final int[] globals;

  /** The static slots of global variables that functions name which it calls. */
  private final SortedSet<Integer> shared;

  /** The slots that it changes, those of global variables behind those of the function. */
  private final BitSet written = new BitSet();

  /**
   * @param head where a turn begins: what a loop jumps back to
   */
  LoopRegion(ScriptFunction function, Program.Tables tables, int head) {
    this.function = function;
    this.head = head;
    long[] instructions = function.instructions();
    first = LoopInstructions.outermost(instructions, head);
    last = LoopInstructions.endOfLoop(instructions, first);
    SortedSet<Integer> called = new TreeSet<>();
    for (int pc = first; pc <= last; pc++) {
      LoopInstructions.called(instructions[pc], tables).ifPresent(called::add);
    }
    shared = GlobalTags.named(tables, called);
    SortedSet<Integer> named = new TreeSet<>(shared);
    for (int pc = first; pc <= last; pc++) {
      for (int operand : LoopInstructions.operands(instructions[pc])) {
        if (isVariable(operand, tables)) {
          named.add(operand);
        }
      }
    }
    variables = named.stream().mapToInt(Integer::intValue).toArray();
    globals = Arrays.stream(variables).filter(o -> !Instruction.isLocal(o)).toArray();
    for (int pc = first; pc <= last; pc++) {
      LoopInstructions.target(instructions[pc]).ifPresent(operand -> written.set(slot(operand)));
    }
  }

  private boolean isVariable(int operand, Program.Tables tables) {
    return Instruction.isLocal(operand)
        ? Instruction.index(operand) < function.variableCount()
        : tables.constant(operand).isEmpty();
  }

  ScriptFunction function() {
    return function;
  }

  int head() {
    return head;
  }

  /** Its first instruction. */
  int first() {
    return first;
  }

  /** Its last instruction. */
  int last() {
    return last;
  }

  /** Whether it has nothing, since even the innermost loop is too long to run directly. */
  boolean isTooLong() {
    return last < head;
  }

  /** The slots of its function and of its global variables. */
  int slotCount() {
    return function.slotCount() + globals.length;
  }

  boolean contains(int pc) {
    return pc >= first && pc <= last;
  }

  /** The static slots of the global variables that it and the functions it calls name. */
  int[] globals() {
    return globals;
  }

  /** Those that functions name which it calls. */
  SortedSet<Integer> shared() {
    return shared;
  }

  /** The tags of the global variables among those of all variables. */
  GlobalTags globals(int[] tags) {
    return new GlobalTags(
        globals, Arrays.copyOfRange(tags, tags.length - globals.length, tags.length));
  }

  /** The slot of a variable or temporary, a global one behind those of the function. */
  private int slot(int operand) {
    return Instruction.isLocal(operand)
        ? Instruction.index(operand)
        : function.slotCount() + Arrays.binarySearch(globals, operand);
  }

  /** Whether some instruction of it changes {@code slot}. */
  boolean writes(int slot) {
    return written.get(slot);
  }

  /** The {@link TagSet} of each variable in the registers, in an order of its own. */
  int[] tags(Registers registers, int base) {
    int[] tags = new int[variables.length];
    for (int i = 0; i < tags.length; i++) {
      tags[i] = TagSet.in(registers, Instruction.slot(variables[i], base));
    }
    return tags;
  }

  /** Whether the variables in the registers have {@code tags}. */
  boolean have(int[] tags, Registers registers, int base) {
    for (int i = 0; i < tags.length; i++) {
      if (tags[i] != TagSet.in(registers, Instruction.slot(variables[i], base))) {
        return false;
      }
    }
    return true;
  }

  /** The tags of all slots, 0 for those it does not name, and behind them of its globals. */
  int[] state(int[] tags) {
    int[] state = new int[slotCount()];
    for (int i = 0; i < tags.length; i++) {
      state[slot(variables[i])] = tags[i];
    }
    return state;
  }
}
