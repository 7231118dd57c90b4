package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.Opcode;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.pendant.script.value.Registers;

/**
 * Direct method: writes bytecode of one {@link DirectForm}: each instruction as the {@link
 * InstructionLoop} interprets it, on the {@link DirectSlots}.
 */
final class DirectMethod {
  private static final ClassDesc LEFT_FRAMES = JvmCode.desc(LeftFrames.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final ClassDesc BOOLEAN = ConstantDescs.CD_boolean;

  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectUnit unit;
  private final long[] instructions;
  private final Label[] labels;

  /** Where it is left for instructions that have to be interpreted. */
  private final Label[] interpreted;

  private final DirectSlots slots;
  private final DirectOperations operations;
  private final DirectElements elements;
  private final DirectRegisters registers;
  private final DirectFrame frame;
  private final List<Runnable> tail = new ArrayList<>();
  private final Map<List<Integer>, Label> exits = new HashMap<>();

  DirectMethod(CodeBuilder code, DirectForm form, DirectUnit unit) {
    this.code = code;
    this.form = form;
    this.unit = unit;
    instructions = form.function().instructions();
    labels = new Label[instructions.length];
    interpreted = new Label[instructions.length];
    for (int i = 0; i < labels.length; i++) {
      labels[i] = code.newLabel();
    }
    slots = new DirectSlots(code, form);
    operations = new DirectOperations(code, form, slots, this::interpreted);
    elements = new DirectElements(code, form, slots, operations, this::interpreted);
    registers = new DirectRegisters(code, form, slots, unit.globals());
    frame =
        form.loop().isPresent()
            ? new LoopFrame(code, form, slots, registers, form.loop().get(), labels)
            : new CalledFrame(code, form, slots, tail);
  }

  /** Writes the method of the form. */
  void write() {
    slots.loadMarks();
    registers.begin();
    frame.begin();
    for (int pc = 0; pc < instructions.length; pc++) {
      if (form.state(pc) != null) {
        code.labelBinding(labels[pc]);
        translate(pc, instructions[pc], form.state(pc));
      }
    }
    for (int i = 0; i < tail.size(); i++) {
      tail.get(i).run();
    }
  }

  // --- ways from one instruction to another

  /** The place to jump to for instruction {@code target} with slots of these tags. */
  private Label edge(int[] from, int target) {
    if (!form.contains(target)) {
      return exit(target, LeftFrames.IN_ANY_FORM, from);
    }
    int[] to = form.state(target);
    if (!slots.converts(from, to)) {
      return labels[target];
    }
    Label label = code.newLabel();
    tail.add(
        () -> {
          code.labelBinding(label);
          slots.convert(from, to);
          code.goto_(labels[target]);
        });
    return label;
  }

  /** Continues with the instruction after {@code pc}, which follows. */
  private void next(int pc, int[] after) {
    if (form.contains(pc + 1)) {
      slots.convert(after, form.state(pc + 1));
    } else {
      code.goto_(exit(pc + 1, LeftFrames.IN_ANY_FORM, after));
    }
  }

  // --- ways out

  /** The place where the frame is left before instruction {@code pc}. */
  private Label exit(int pc, int how, int[] state) {
    Label label = code.newLabel();
    tail.add(
        () -> {
          code.labelBinding(label);
          slots.writeBudgetBack();
          code.loadConstant(pc)
              .istore(slots.pcVariable)
              .loadConstant(how)
              .istore(slots.howVariable);
          code.goto_(exit(state));
        });
    return label;
  }

  /** The place where the frame is left before an instruction that has to be interpreted. */
  private Supplier<Label> interpreted(int pc) {
    return () -> {
      if (interpreted[pc] == null) {
        interpreted[pc] = exit(pc, LeftFrames.INTERPRETED, form.state(pc));
      }
      return interpreted[pc];
    };
  }

  /** The place where the frame is left as its variables for the instruction and how say. */
  private Label exit(int[] state) {
    List<Integer> key = Arrays.stream(state).boxed().toList();
    Label known = exits.get(key);
    if (known != null) {
      return known;
    }
    Label label = code.newLabel();
    exits.put(key, label);
    tail.add(
        () -> {
          code.labelBinding(label);
          frame.leave(state);
        });
    return label;
  }

  // --- instructions

  private void translate(int pc, long w, int[] state) {
    int[] after = form.after(pc, state);
    int operation = Instruction.operation(w);
    if (after == null) {
      giveUp(pc, w, state);
      return;
    }
    int a = Instruction.a(w);
    int b = Instruction.b(w);
    int c = Instruction.c(w);
    int far = pc + 1 + Instruction.distance(w);
    int near = pc + 1 + c;
    registers.loadGlobals(w, state);
    switch (operation) {
      case Op.MOVE, Op.COPY -> {
        operations.guard(b, state, Registers.NONE, interpreted(pc));
        operations.copy(a, b, state, after);
      }
      case Op.UNSET, Op.JUMP_IF_GIVEN -> {}
      case Op.MARK -> slots.mark(Instruction.distance(w));
      case Op.ASSIGN, Op.ASSIGN_COPY -> operations.assign(pc, a, b, state, after);
      case Op.ADD, Op.SUBTRACT, Op.MULTIPLY ->
          operations.arithmetic(pc, operation, a, b, c, state, after);
      case Op.DIVIDE -> operations.divide(pc, a, b, c, state);
      case Op.MODULO -> operations.modulo(pc, a, b, c, state);
      case Op.NEGATE -> operations.negate(pc, a, b, state, after);
      case Op.EQUAL ->
          operations.truth(a, one -> operations.equal(pc, b, c, state, Opcode.IFEQ, one));
      case Op.NOT_EQUAL ->
          operations.truth(a, one -> operations.equal(pc, b, c, state, Opcode.IFNE, one));
      case Op.LESS ->
          operations.truth(a, one -> operations.order(pc, b, c, state, Opcode.IFLT, one));
      case Op.LESS_OR_EQUAL ->
          operations.truth(a, one -> operations.order(pc, b, c, state, Opcode.IFLE, one));
      case Op.NOT -> operations.truth(a, one -> operations.jumpIf(pc, b, state, Opcode.IFEQ, one));
      case Op.GET_INDEX -> elements.get(pc, a, b, state, after, c);
      case Op.GET_INDEX_2 -> elements.get(pc, a, b, state, after, c, c + 1);
      case Op.SET_INDEX -> elements.set(pc, a, c, state, b);
      case Op.SET_INDEX_2 -> elements.set(pc, a, c, state, b, b + 1);
      case Op.JUMP -> code.goto_(edge(after, far));
      case Op.LOOP -> turn(pc, far, a, after);
      case Op.JUMP_IF_FALSE -> operations.jumpIf(pc, a, state, Opcode.IFEQ, edge(after, far));
      case Op.JUMP_IF_TRUE -> operations.jumpIf(pc, a, state, Opcode.IFNE, edge(after, far));
      case Op.JUMP_IF_LESS -> operations.order(pc, a, b, state, Opcode.IFLT, edge(after, near));
      case Op.JUMP_IF_LESS_OR_EQUAL ->
          operations.order(pc, a, b, state, Opcode.IFLE, edge(after, near));
      case Op.JUMP_IF_NOT_LESS -> operations.order(pc, a, b, state, Opcode.IFGE, edge(after, near));
      case Op.JUMP_IF_NOT_LESS_OR_EQUAL ->
          operations.order(pc, a, b, state, Opcode.IFGT, edge(after, near));
      case Op.JUMP_IF_EQUAL -> operations.equal(pc, a, b, state, Opcode.IFEQ, edge(after, near));
      case Op.JUMP_IF_NOT_EQUAL ->
          operations.equal(pc, a, b, state, Opcode.IFNE, edge(after, near));
      case Op.LOOP_IF_LESS -> {
        operations.order(pc, a, b, state, Opcode.IFGE, edge(after, pc + 1));
        turn(pc, near, 0, after);
      }
      case Op.LOOP_IF_LESS_OR_EQUAL -> {
        operations.order(pc, a, b, state, Opcode.IFGT, edge(after, pc + 1));
        turn(pc, near, 0, after);
      }
      case Op.CALL -> call(pc, w, state, after);
      case Op.RETURN -> giveBack(pc, a, state);
      case Op.RETURN_NONE -> giveBackNone();
      case Op.STRETCH ->
          slots.count(Cost.STRETCH_NS, exit(pc + 1, LeftFrames.IN_NEXT_SLICE, state));
      default -> throw new IllegalStateException("operation " + operation);
    }
    switch (operation) {
      case Op.JUMP,
          Op.LOOP,
          Op.LOOP_IF_LESS,
          Op.LOOP_IF_LESS_OR_EQUAL,
          Op.RETURN,
          Op.RETURN_NONE -> {}
      case Op.JUMP_IF_GIVEN -> jumpIfGiven(pc, a, far, state);
      default -> {
        registers.storeGlobal(w, after);
        next(pc, after);
      }
    }
  }

  /** Leaves at an instruction that is never done here. */
  private void giveUp(int pc, long w, int[] state) {
    DirectForm callee = Instruction.operation(w) == Op.CALL ? form.callee(w, state) : null;
    boolean call = Instruction.operation(w) == Op.CALL;
    if (callee != null) {
      // it never returns, but it may stop inside
      arguments(w, callee, state);
      code.pop2();
      leaveWithCallee(pc, w, state);
      return;
    }
    boolean anyForm = call || (form.loop().isPresent() && LoopInstructions.endsBefore(w));
    code.goto_(exit(pc, anyForm ? LeftFrames.IN_ANY_FORM : LeftFrames.INTERPRETED, state));
  }

  private void jumpIfGiven(int pc, int parameter, int target, int[] state) {
    int tags = form.tags(parameter, state);
    if ((tags & TagSet.UNASSIGNED) == 0) {
      code.goto_(edge(state, target));
      return;
    }
    if (tags != TagSet.UNASSIGNED) {
      slots.pushTag(parameter, state);
      code.loadConstant(Registers.UNASSIGNED).if_icmpne(edge(state, target));
    }
    next(pc, state);
  }

  // --- loops and calls

  private void turn(int pc, int target, int free, int[] after) {
    slots.count(Cost.turn(pc + 1 - target - free), exit(target, LeftFrames.IN_NEXT_SLICE, after));
    code.goto_(edge(after, target));
  }

  /** Calls {@code callee} with its arguments. */
  private void arguments(long w, DirectForm callee, int[] state) {
    int first = Instruction.index(Instruction.c(w));
    slots.writeBudgetBack();
    registers.storeShared(state);
    code.aload(DirectSlots.THREAD).iload(DirectSlots.ROOM).iconst_1().isub();
    for (int i = 0; i < callee.function().parameterCount(); i++) {
      int slot = first + i;
      switch (DirectSlots.Kept.of(state[slot])) {
        case NOT -> {}
        case LONG -> code.lload(slots.longs[slot]);
        case DOUBLE -> code.dload(slots.doubles[slot]);
        case TAGGED -> code.dload(slots.doubles[slot]).iload(slots.tagVariables[slot]);
      }
    }
    code.invokestatic(DirectUnit.SELF, unit.method(callee), DirectSlots.type(callee));
  }

  private void call(int pc, long w, int[] state, int[] after) {
    DirectForm callee = form.callee(w, state);
    arguments(w, callee, state);
    int slot = Instruction.index(Instruction.a(w));
    Label left = code.newLabel();
    if (DirectSlots.returnsLong(callee)) {
      code.lstore(slots.longs[slot])
          .lload(slots.longs[slot])
          .loadConstant(DirectSlots.LEFT)
          .lcmp()
          .ifeq(left);
    } else {
      Label valid = code.newLabel();
      Label unclear = code.newLabel();
      code.dstore(slots.doubles[slot])
          .dload(slots.doubles[slot])
          .dload(slots.doubles[slot])
          .dcmpl()
          .ifne(unclear);
      code.labelBinding(valid);
      if (DirectSlots.Kept.of(callee.result()) == DirectSlots.Kept.TAGGED) {
        code.aload(DirectSlots.THREAD)
            .getfield(JvmCode.THREAD, "resultTag", INT)
            .istore(slots.tagVariables[slot]);
      }
      tail.add(
          () -> {
            code.labelBinding(unclear);
            slots.leftFrames();
            code.getfield(LEFT_FRAMES, "leaving", BOOLEAN).ifeq(valid).goto_(left);
          });
    }
    slots.loadBudget();
    registers.loadShared(after);
    tail.add(
        () -> {
          code.labelBinding(left);
          leaveWithCallee(pc, w, state);
        });
  }

  /** Leaves at a call that was not begun, or has been left inside. */
  private void leaveWithCallee(int pc, long w, int[] state) {
    int[] before = registers.withoutShared(state);
    before[Instruction.index(Instruction.a(w))] = 0;
    slots.leftFrames();
    code.invokevirtual(LEFT_FRAMES, "entered", MethodTypeDesc.of(INT))
        .loadConstant(pc)
        .iadd()
        .istore(slots.pcVariable)
        .loadConstant(LeftFrames.IN_ANY_FORM)
        .istore(slots.howVariable)
        .goto_(exit(before));
  }

  private void giveBack(int pc, int operand, int[] state) {
    operations.guard(operand, state, Registers.NONE, interpreted(pc));
    slots.writeBudgetBack();
    switch (DirectSlots.Kept.of(form.result())) {
      case NOT -> code.lconst_0().lreturn();
      case LONG -> {
        slots.pushLong(operand, state);
        code.lreturn();
      }
      case DOUBLE -> {
        slots.pushDouble(operand, state);
        code.dreturn();
      }
      case TAGGED -> {
        code.aload(DirectSlots.THREAD);
        slots.pushTag(operand, state);
        code.putfield(JvmCode.THREAD, "resultTag", INT);
        slots.pushDouble(operand, state);
        code.dreturn();
      }
    }
  }

  private void giveBackNone() {
    slots.writeBudgetBack();
    if (DirectSlots.returnsLong(form)) {
      code.lconst_0().lreturn();
    } else {
      code.aload(DirectSlots.THREAD)
          .loadConstant((int) Registers.NONE)
          .putfield(JvmCode.THREAD, "resultTag", INT)
          .dconst_0()
          .dreturn();
    }
  }
}
