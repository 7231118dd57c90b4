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
  static final ClassDesc CODE = JvmCode.desc(DirectCode.class);
  private static final ClassDesc LEFT_FRAMES = JvmCode.desc(LeftFrames.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final ClassDesc DOUBLE = ConstantDescs.CD_double;
  private static final ClassDesc BOOLEAN = ConstantDescs.CD_boolean;
  private static final ClassDesc VOID = ConstantDescs.CD_void;

  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectUnit unit;
  private final long[] instructions;
  private final Label[] labels;

  /** Where it is left for instructions that have to be interpreted. */
  private final Label[] interpreted;

  private final DirectSlots slots;
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
  }

  /** Writes the method of the form. */
  void write() {
    begin();
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

  /** Counts the call, if it can be begun. */
  private void begin() {
    Label refused = code.newLabel();
    code.aload(DirectSlots.THREAD).getfield(JvmCode.THREAD, "budget", INT).iflt(refused);
    code.iload(DirectSlots.ROOM).iflt(refused);
    slots.loadBudget();
    slots.count(form.function().callNs());
    int[] given = new int[form.function().slotCount()];
    for (int i = 0; i < form.function().variableCount(); i++) {
      given[i] = i < form.function().parameterCount() ? form.parameter(i) : TagSet.UNASSIGNED;
    }
    slots.convert(given, form.state(0));
    tail.add(
        () -> {
          code.labelBinding(refused);
          slots.leftFrames();
          code.invokevirtual(LEFT_FRAMES, "refuse", MethodTypeDesc.of(VOID));
          slots.returnLeft();
        });
  }

  // --- ways from one instruction to another

  /** The place to jump to for instruction {@code target} with slots of these tags. */
  private Label edge(int[] from, int target) {
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
    slots.convert(after, form.state(pc + 1));
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
    tail.add(() -> leave(label, state));
    return label;
  }

  private void leave(Label label, int[] state) {
    code.labelBinding(label);
    slots.leftFrames();
    code.dup()
        .astore(slots.leftVariable)
        .loadConstant(form.number())
        .iload(slots.pcVariable)
        .iload(slots.howVariable)
        .invokevirtual(LEFT_FRAMES, "frame", MethodTypeDesc.of(VOID, INT, INT, INT));
    for (int i = 0; i < state.length; i++) {
      if (state[i] != 0) {
        code.aload(slots.leftVariable).loadConstant(i);
        slots.pushTag(Instruction.local(i), state);
        slots.pushNumber(i, state[i]);
        code.invokevirtual(LEFT_FRAMES, "slot", MethodTypeDesc.of(VOID, INT, INT, DOUBLE));
      }
    }
    slots.returnLeft();
  }

  // --- guards

  /** Leaves when {@code operand} has none of the tags up to {@code most}. */
  private void guard(int operand, int[] state, int most, Supplier<Label> exit) {
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
  private void guardTarget(int target, int[] state, Supplier<Label> exit) {
    if (form.isVariable(target)
        && !TagSet.within(form.tags(target, state), TagSet.NUMBER | TagSet.UNASSIGNED)) {
      slots.pushTag(target, state);
      code.loadConstant(Processor.NOT_FOR_NUMBER).iand().ifne(exit.get());
    }
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
    switch (operation) {
      case Op.MOVE, Op.COPY -> {
        guard(b, state, Registers.NONE, interpreted(pc));
        copy(a, b, state, after);
      }
      case Op.UNSET, Op.JUMP_IF_GIVEN -> {}
      case Op.ASSIGN, Op.ASSIGN_COPY -> assign(pc, a, b, state, after);
      case Op.ADD, Op.SUBTRACT, Op.MULTIPLY -> arithmetic(pc, operation, a, b, c, state, after);
      case Op.DIVIDE -> divide(pc, a, b, c, state);
      case Op.MODULO -> modulo(pc, a, b, c, state);
      case Op.NEGATE -> negate(pc, a, b, state, after);
      case Op.EQUAL -> truth(a, one -> equal(pc, b, c, state, Opcode.IFEQ, one));
      case Op.NOT_EQUAL -> truth(a, one -> equal(pc, b, c, state, Opcode.IFNE, one));
      case Op.LESS -> truth(a, one -> order(pc, b, c, state, Opcode.IFLT, one));
      case Op.LESS_OR_EQUAL -> truth(a, one -> order(pc, b, c, state, Opcode.IFLE, one));
      case Op.NOT -> truth(a, one -> jumpIf(pc, b, state, Opcode.IFEQ, one));
      case Op.JUMP -> code.goto_(edge(after, far));
      case Op.LOOP -> turn(pc, far, a, after);
      case Op.JUMP_IF_FALSE -> jumpIf(pc, a, state, Opcode.IFEQ, edge(after, far));
      case Op.JUMP_IF_TRUE -> jumpIf(pc, a, state, Opcode.IFNE, edge(after, far));
      case Op.JUMP_IF_LESS -> order(pc, a, b, state, Opcode.IFLT, edge(after, near));
      case Op.JUMP_IF_LESS_OR_EQUAL -> order(pc, a, b, state, Opcode.IFLE, edge(after, near));
      case Op.JUMP_IF_NOT_LESS -> order(pc, a, b, state, Opcode.IFGE, edge(after, near));
      case Op.JUMP_IF_NOT_LESS_OR_EQUAL -> order(pc, a, b, state, Opcode.IFGT, edge(after, near));
      case Op.JUMP_IF_EQUAL -> equal(pc, a, b, state, Opcode.IFEQ, edge(after, near));
      case Op.JUMP_IF_NOT_EQUAL -> equal(pc, a, b, state, Opcode.IFNE, edge(after, near));
      case Op.LOOP_IF_LESS -> {
        order(pc, a, b, state, Opcode.IFGE, edge(after, pc + 1));
        turn(pc, near, 0, after);
      }
      case Op.LOOP_IF_LESS_OR_EQUAL -> {
        order(pc, a, b, state, Opcode.IFGT, edge(after, pc + 1));
        turn(pc, near, 0, after);
      }
      case Op.CALL -> call(pc, w, state);
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
      default -> next(pc, after);
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
    code.goto_(exit(pc, call ? LeftFrames.WITH_CALL : LeftFrames.INTERPRETED, state));
  }

  /** Keeps in {@code target} what {@code source} holds. */
  private void copy(int target, int source, int[] state, int[] after) {
    int slot = Instruction.index(target);
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

  private void assign(int pc, int target, int source, int[] state, int[] after) {
    if (!TagSet.assignable(form.tags(target, state), form.tags(source, state))) {
      Label fast = code.newLabel();
      Supplier<Label> exit = interpreted(pc);
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

  private void arithmetic(
      int pc, int operation, int target, int x, int y, int[] state, int[] after) {
    Supplier<Label> exit = interpreted(pc);
    guard(x, state, Registers.FLOAT, exit);
    guard(y, state, Registers.FLOAT, exit);
    guardTarget(target, state, exit);
    int slot = Instruction.index(target);
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

  private void divide(int pc, int target, int x, int y, int[] state) {
    Supplier<Label> exit = interpreted(pc);
    guard(x, state, Registers.FLOAT, exit);
    guard(y, state, Registers.FLOAT, exit);
    guardTarget(target, state, exit);
    slots.pushDouble(y, state);
    code.dconst_0().dcmpl().ifeq(exit.get());
    slots.pushDouble(x, state);
    slots.pushDouble(y, state);
    code.ddiv().dstore(slots.doubles[Instruction.index(target)]);
  }

  private void modulo(int pc, int target, int x, int y, int[] state) {
    Supplier<Label> exit = interpreted(pc);
    guard(x, state, Registers.INT, exit);
    guard(y, state, Registers.INT, exit);
    guardTarget(target, state, exit);
    slots.pushLong(y, state);
    code.lconst_0().lcmp().ifeq(exit.get());
    slots.pushLong(x, state);
    code.l2i();
    slots.pushLong(y, state);
    code.l2i().irem().i2l().lstore(slots.longs[Instruction.index(target)]);
  }

  private void negate(int pc, int target, int x, int[] state, int[] after) {
    Supplier<Label> exit = interpreted(pc);
    guard(x, state, Registers.FLOAT, exit);
    guardTarget(target, state, exit);
    int slot = Instruction.index(target);
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

  private interface Jump {
    void to(Label one);
  }

  /** Stores whether {@code jump} jumps. */
  private void truth(int target, Jump jump) {
    int slot = Instruction.index(target);
    Label one = code.newLabel();
    Label done = code.newLabel();
    jump.to(one);
    code.lconst_0().lstore(slots.longs[slot]).goto_(done);
    code.labelBinding(one).lconst_1().lstore(slots.longs[slot]);
    code.labelBinding(done);
  }

  private void order(int pc, int x, int y, int[] state, Opcode when, Label target) {
    Supplier<Label> exit = interpreted(pc);
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

  private void equal(int pc, int x, int y, int[] state, Opcode when, Label target) {
    if (form.tags(x, state) == TagSet.BOOL && form.tags(y, state) == TagSet.BOOL) {
      slots.pushLong(x, state);
      slots.pushLong(y, state);
      code.lcmp().branch(when, target);
      return;
    }
    Supplier<Label> exit = interpreted(pc);
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

  private void jumpIf(int pc, int operand, int[] state, Opcode when, Label target) {
    guard(operand, state, Registers.BOOL, interpreted(pc));
    slots.pushDouble(operand, state);
    code.dconst_0().dcmpl().branch(when, target);
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

  private void call(int pc, long w, int[] state) {
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
    tail.add(
        () -> {
          code.labelBinding(left);
          leaveWithCallee(pc, w, state);
        });
  }

  /** Leaves at a call that was not begun, or has been left inside. */
  private void leaveWithCallee(int pc, long w, int[] state) {
    int[] before = state.clone();
    before[Instruction.index(Instruction.a(w))] = 0;
    slots.leftFrames();
    code.invokevirtual(LEFT_FRAMES, "entered", MethodTypeDesc.of(INT))
        .loadConstant(pc)
        .iadd()
        .istore(slots.pcVariable)
        .loadConstant(LeftFrames.WITH_CALL)
        .istore(slots.howVariable)
        .goto_(exit(before));
  }

  private void giveBack(int pc, int operand, int[] state) {
    guard(operand, state, Registers.NONE, interpreted(pc));
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
