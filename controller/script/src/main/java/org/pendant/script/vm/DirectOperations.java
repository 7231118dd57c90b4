package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.Opcode;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.pendant.script.value.Registers;

/**
 * Direct operations: bytecode of the instructions of a {@link DirectForm} that copy, compute and
 * compare plain values. Each leaves the method before an instruction that has other operands than
 * it was made for.
 */
final class DirectOperations {
  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectSlots slots;

  /** Where an instruction is left that has to be interpreted. */
  private final IntFunction<Supplier<Label>> exits;

  DirectOperations(
      CodeBuilder code, DirectForm form, DirectSlots slots, IntFunction<Supplier<Label>> exits) {
    this.code = code;
    this.form = form;
    this.slots = slots;
    this.exits = exits;
  }

  // --- guards

  /** Leaves when {@code operand} has none of the tags up to {@code most}. */
  void guard(int operand, int[] state, int most, Supplier<Label> exit) {
    int tags = form.tags(operand, state);
    boolean known =
        switch (most) {
          case Registers.INT -> TagSet.within(tags, TagSet.INT);
          case Registers.FLOAT -> TagSet.within(tags, TagSet.NUMBER);
          case Registers.BOOL -> TagSet.within(tags, TagSet.NUMBER | TagSet.BOOL);
          default -> TagSet.within(tags, TagSet.PLAIN);
        };
    if (!known) {
      slots.pushTag(operand, state);
      code.loadConstant(most).if_icmpgt(exit.get());
    }
  }

  /** Leaves when a number must not be stored into {@code target} as it is. */
  void guardTarget(int target, int[] state, Supplier<Label> exit) {
    if (form.isVariable(target)
        && !TagSet.within(form.tags(target, state), TagSet.NUMBER | TagSet.UNASSIGNED)) {
      slots.pushTag(target, state);
      code.loadConstant(Processor.NOT_FOR_NUMBER).iand().ifne(exit.get());
    }
  }

  /** Keeps in {@code target} what {@code source} holds. */
  void copy(int target, int source, int[] state, int[] after) {
    int slot = form.slot(target);
    switch (DirectSlots.Kept.of(after[slot])) {
      case NOT -> {}
      case LONG -> {
        slots.pushLong(source, state);
        code.lstore(slots.longs[slot]);
      }
      case DOUBLE -> {
        slots.pushDouble(source, state);
        code.dstore(slots.doubles[slot]);
      }
      case TAGGED -> {
        slots.pushDouble(source, state);
        slots.pushTag(source, state);
        code.istore(slots.tagVariables[slot]).dstore(slots.doubles[slot]);
      }
    }
  }

  void assign(int pc, int target, int source, int[] state, int[] after) {
    if (!TagSet.assignable(form.tags(target, state), form.tags(source, state))) {
      Label fast = code.newLabel();
      Supplier<Label> exit = exits.apply(pc);
      slots.pushTag(source, state);
      slots.pushTag(target, state);
      code.ior().iconst_1().if_icmple(fast);
      slots.pushTag(target, state);
      code.loadConstant(Registers.UNASSIGNED).if_icmpne(exit.get());
      slots.pushTag(source, state);
      code.loadConstant(Registers.BOOL).if_icmpgt(exit.get());
      code.labelBinding(fast);
    }
    copy(target, source, state, after);
  }

  private boolean ints(int x, int y, int[] state) {
    return ((form.tags(x, state) | form.tags(y, state)) & TagSet.NUMBER) == TagSet.INT;
  }

  void arithmetic(int pc, int operation, int target, int x, int y, int[] state, int[] after) {
    Supplier<Label> exit = exits.apply(pc);
    guard(x, state, Registers.FLOAT, exit);
    guard(y, state, Registers.FLOAT, exit);
    guardTarget(target, state, exit);
    int slot = form.slot(target);
    if (after[slot] == TagSet.INT) {
      slots.pushLong(x, state);
      slots.pushLong(y, state);
      switch (operation) {
        case Op.ADD -> code.ladd();
        case Op.SUBTRACT -> code.lsub();
        default -> code.lmul();
      }
      storeInt(slot, exit);
      return;
    }
    if (after[slot] != TagSet.FLOAT) {
      slots.pushTag(x, state);
      slots.pushTag(y, state);
      code.ior().istore(slots.tagVariable);
    }
    slots.pushDouble(x, state);
    slots.pushDouble(y, state);
    switch (operation) {
      case Op.ADD -> code.dadd();
      case Op.SUBTRACT -> code.dsub();
      default -> code.dmul();
    }
    storeNumber(slot, after[slot], exit);
  }

  /** Stores the long on the stack as an int, if it is one. */
  private void storeInt(int slot, Supplier<Label> exit) {
    code.dup2()
        .lstore(slots.numberVariable)
        .l2i()
        .i2l()
        .lload(slots.numberVariable)
        .lcmp()
        .ifne(exit.get());
    code.lload(slots.numberVariable).lstore(slots.longs[slot]);
  }

  /** Stores the double on the stack, whose tag stands in a variable unless it is a float. */
  private void storeNumber(int slot, int tags, Supplier<Label> exit) {
    if (tags == TagSet.FLOAT) {
      code.dstore(slots.doubles[slot]);
      return;
    }
    Label fits = code.newLabel();
    code.dstore(slots.numberVariable).iload(slots.tagVariable).ifne(fits);
    code.dload(slots.numberVariable).dup2().d2i().i2d().dcmpl().ifne(exit.get());
    // an int has no negative zero
    code.dload(slots.numberVariable).dconst_0().dadd().dstore(slots.numberVariable);
    code.labelBinding(fits);
    code.dload(slots.numberVariable).dstore(slots.doubles[slot]);
    code.iload(slots.tagVariable).istore(slots.tagVariables[slot]);
  }

  void divide(int pc, int target, int x, int y, int[] state) {
    Supplier<Label> exit = exits.apply(pc);
    guard(x, state, Registers.FLOAT, exit);
    guard(y, state, Registers.FLOAT, exit);
    guardTarget(target, state, exit);
    slots.pushDouble(y, state);
    code.dconst_0().dcmpl().ifeq(exit.get());
    slots.pushDouble(x, state);
    slots.pushDouble(y, state);
    code.ddiv().dstore(slots.doubles[form.slot(target)]);
  }

  void modulo(int pc, int target, int x, int y, int[] state) {
    Supplier<Label> exit = exits.apply(pc);
    guard(x, state, Registers.INT, exit);
    guard(y, state, Registers.INT, exit);
    guardTarget(target, state, exit);
    slots.pushLong(y, state);
    code.lconst_0().lcmp().ifeq(exit.get());
    slots.pushLong(x, state);
    code.l2i();
    slots.pushLong(y, state);
    code.l2i().irem().i2l().lstore(slots.longs[form.slot(target)]);
  }

  void negate(int pc, int target, int x, int[] state, int[] after) {
    Supplier<Label> exit = exits.apply(pc);
    guard(x, state, Registers.FLOAT, exit);
    guardTarget(target, state, exit);
    int slot = form.slot(target);
    if (after[slot] == TagSet.INT) {
      slots.pushLong(x, state);
      code.lneg();
      storeInt(slot, exit);
      return;
    }
    if (after[slot] != TagSet.FLOAT) {
      slots.pushTag(x, state);
      code.istore(slots.tagVariable);
    }
    slots.pushDouble(x, state);
    code.dneg();
    storeNumber(slot, after[slot], exit);
  }

  // --- truth

  interface Jump {
    void to(Label one);
  }

  /** Stores whether {@code jump} jumps. */
  void truth(int target, Jump jump) {
    int slot = form.slot(target);
    Label one = code.newLabel();
    Label done = code.newLabel();
    jump.to(one);
    code.lconst_0().lstore(slots.longs[slot]).goto_(done);
    code.labelBinding(one).lconst_1().lstore(slots.longs[slot]);
    code.labelBinding(done);
  }

  /** Jumps to {@code target} when the order of two numbers is as {@code when} says. */
  void order(int pc, int x, int y, int[] state, Opcode when, Label target) {
    Supplier<Label> exit = exits.apply(pc);
    guard(x, state, Registers.FLOAT, exit);
    guard(y, state, Registers.FLOAT, exit);
    if (ints(x, y, state)) {
      slots.pushLong(x, state);
      slots.pushLong(y, state);
      code.lcmp().branch(when, target);
    } else {
      slots.pushDouble(x, state);
      slots.pushDouble(y, state);
      // a comparison with NaN counts as greater
      code.dcmpg().branch(when, target);
    }
  }

  /**
   * Jumps to {@code target} when two bools or numbers are equal, or are not, as {@code when} says.
   */
  void equal(int pc, int x, int y, int[] state, Opcode when, Label target) {
    if (form.tags(x, state) == TagSet.BOOL && form.tags(y, state) == TagSet.BOOL) {
      slots.pushLong(x, state);
      slots.pushLong(y, state);
      code.lcmp().branch(when, target);
      return;
    }
    Supplier<Label> exit = exits.apply(pc);
    guard(x, state, Registers.FLOAT, exit);
    guard(y, state, Registers.FLOAT, exit);
    if (ints(x, y, state)) {
      slots.pushLong(x, state);
      slots.pushLong(y, state);
      code.lcmp().branch(when, target);
    } else {
      slots.pushDouble(x, state);
      slots.pushDouble(y, state);
      code.dcmpl().branch(when, target);
    }
  }

  /** Jumps to {@code target} when a value is true, or is not, as {@code when} says. */
  void jumpIf(int pc, int operand, int[] state, Opcode when, Label target) {
    guard(operand, state, Registers.BOOL, exits.apply(pc));
    slots.pushDouble(operand, state);
    code.dconst_0().dcmpl().branch(when, target);
  }
}
