package org.pendant.script.vm;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Registers;
import org.pendant.script.value.Value;

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
    SortedSet<Integer> named = new TreeSet<>();
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

  /** The static slots of the global variables that it names. */
  int[] globals() {
    return globals;
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
      tags[i] = tag(registers, Instruction.slot(variables[i], base));
    }
    return tags;
  }

  /** Whether the variables in the registers have {@code tags}. */
  boolean have(int[] tags, Registers registers, int base) {
    for (int i = 0; i < tags.length; i++) {
      if (tags[i] != tag(registers, Instruction.slot(variables[i], base))) {
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

  private static int tag(Registers registers, int slot) {
    int tag = registers.tags()[slot];
    return tag == Registers.OBJECT ? tag(registers.objects()[slot]) : TagSet.of(tag);
  }

  private static int tag(Value object) {
    if (object instanceof NumberList list) {
      return switch (list.tag()) {
        case Registers.INT -> TagSet.INT_LIST;
        case Registers.FLOAT -> TagSet.FLOAT_LIST;
        default -> TagSet.OBJECT;
      };
    }
    if (object instanceof MatrixValue matrix) {
      return matrix.integers() ? TagSet.INT_MATRIX : TagSet.FLOAT_MATRIX;
    }
    return TagSet.OBJECT;
  }
}
