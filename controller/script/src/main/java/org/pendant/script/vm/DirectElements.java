package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.pendant.script.value.Registers;

/**
 * Direct elements: bytecode that reads and changes elements of lists and matrices of numbers, whose
 * arrays are variables of the method.
 */
final class DirectElements {
  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectSlots slots;
  private final DirectOperations operations;

  /** Where an instruction is left that has to be interpreted. */
  private final IntFunction<Supplier<Label>> exits;

  DirectElements(
      CodeBuilder code,
      DirectForm form,
      DirectSlots slots,
      DirectOperations operations,
      IntFunction<Supplier<Label>> exits) {
    this.code = code;
    this.form = form;
    this.slots = slots;
    this.operations = operations;
    this.exits = exits;
  }

  /**
   * Reads an element.
   *
   * @param indices one of a list, row and column of a matrix
   */
  void get(int pc, int target, int container, int[] state, int[] after, int... indices) {
    Supplier<Label> exit = exits.apply(pc);
    operations.guardTarget(target, state, exit);
    place(form.slot(container), state, exit, indices);
    int slot = form.slot(target);
    code.aload(slots.elements[form.slot(container)]).iload(slots.indexVariable).daload();
    if (after[slot] == TagSet.FLOAT) {
      code.dstore(slots.doubles[slot]);
    } else {
      code.d2l().lstore(slots.longs[slot]);
    }
  }

  /** Replaces an element. */
  void set(int pc, int container, int source, int[] state, int... indices) {
    Supplier<Label> exit = exits.apply(pc);
    int slot = form.slot(container);
    boolean ints = TagSet.element(state[slot]) == TagSet.INT;
    operations.guard(source, state, ints ? Registers.INT : Registers.FLOAT, exit);
    code.iload(slots.owned(slot)).ifeq(exit.get());
    place(slot, state, exit, indices);
    code.aload(slots.elements[slot]).iload(slots.indexVariable);
    slots.pushDouble(source, state);
    code.dastore();
  }

  /** Finds where an element is in the array, and leaves if there is none. */
  private void place(int slot, int[] state, Supplier<Label> exit, int... indices) {
    index(indices[0], state, slots.length(slot), exit);
    if (indices.length > 1) {
      code.iload(slots.indexVariable).iload(slots.columns(slot)).imul().istore(slots.rowVariable);
      index(indices[1], state, slots.columns(slot), exit);
      code.iload(slots.rowVariable).iload(slots.indexVariable).iadd().istore(slots.indexVariable);
    }
  }

  /** Keeps an index below what is in variable {@code end}. */
  private void index(int operand, int[] state, int end, Supplier<Label> exit) {
    operations.guard(operand, state, Registers.INT, exit);
    slots.pushLong(operand, state);
    code.l2i().istore(slots.indexVariable);
    code.iload(slots.indexVariable).iflt(exit.get());
    code.iload(slots.indexVariable).iload(end).if_icmpge(exit.get());
  }
}
