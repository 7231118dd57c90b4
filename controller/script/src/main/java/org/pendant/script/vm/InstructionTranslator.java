package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.Opcode;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.List;
import org.pendant.script.value.Registers;
import org.pendant.script.vm.Processor.Stop;

/**
 * Instruction translator: translates single instructions, each as the {@link InstructionLoop}
 * interprets it.
 */
final class InstructionTranslator {
  private final JvmCode registers;
  private final CodeBuilder code;
  private final Label[] labels;
  private final List<Runnable> tail = new ArrayList<>();

  /** Returns the {@link Stop} on the operand stack. */
  private final Label stopped;

  InstructionTranslator(JvmCode registers, int instructions) {
    this.registers = registers;
    this.code = registers.code();
    labels = new Label[instructions];
    for (int i = 0; i < instructions; i++) {
      labels[i] = code.newLabel();
    }
    stopped = code.newLabel();
  }

  /** The place of instruction {@code pc}. */
  Label label(int pc) {
    return labels[pc];
  }

  /** The operands of {@code w} whose number or tag its translation reads. */
  static int[] numbers(long w) {
    int a = Instruction.a(w);
    int b = Instruction.b(w);
    int c = Instruction.c(w);
    return switch (Instruction.operation(w)) {
      case Op.ADD,
          Op.SUBTRACT,
          Op.MULTIPLY,
          Op.DIVIDE,
          Op.MODULO,
          Op.GET_INDEX,
          Op.SET_INDEX,
          Op.EQUAL,
          Op.NOT_EQUAL,
          Op.LESS,
          Op.LESS_OR_EQUAL ->
          new int[] {a, b, c};
      case Op.ASSIGN,
          Op.ASSIGN_COPY,
          Op.NEGATE,
          Op.JUMP_IF_LESS,
          Op.JUMP_IF_LESS_OR_EQUAL,
          Op.JUMP_IF_NOT_LESS,
          Op.JUMP_IF_NOT_LESS_OR_EQUAL,
          Op.JUMP_IF_EQUAL,
          Op.JUMP_IF_NOT_EQUAL,
          Op.LOOP_IF_LESS,
          Op.LOOP_IF_LESS_OR_EQUAL ->
          new int[] {a, b};
      case Op.GET_INDEX_2 -> new int[] {a, b, c, c + 1};
      case Op.SET_INDEX_2 -> new int[] {a, b, b + 1, c};
      case Op.MOVE, Op.COPY, Op.NOT -> new int[] {b};
      case Op.RETURN, Op.JUMP_IF_FALSE, Op.JUMP_IF_TRUE -> new int[] {a};
      default -> new int[0];
    };
  }

  void translate(int pc, long w) {
    int a = Instruction.a(w);
    int b = Instruction.b(w);
    int c = Instruction.c(w);
    int operation = Instruction.operation(w);
    switch (operation) {
      case Op.MOVE, Op.COPY -> move(pc, a, b, operation == Op.COPY);
      case Op.ASSIGN, Op.ASSIGN_COPY -> assign(pc, a, b);
      case Op.UNSET -> registers.storeTag(a, () -> code.loadConstant(Registers.UNASSIGNED));
      case Op.ADD, Op.SUBTRACT, Op.MULTIPLY -> arithmetic(pc, operation, a, b, c);
      case Op.DIVIDE -> divide(pc, a, b, c);
      case Op.MODULO -> modulo(pc, a, b, c);
      case Op.NEGATE -> negate(pc, a, b);
      case Op.EQUAL -> equal(pc, a, b, c, true);
      case Op.NOT_EQUAL -> equal(pc, a, b, c, false);
      case Op.LESS -> order(pc, a, b, c, Opcode.IFLT);
      case Op.LESS_OR_EQUAL -> order(pc, a, b, c, Opcode.IFLE);
      case Op.NOT -> not(pc, a, b);
      case Op.JUMP_IF_GIVEN -> jumpIfGiven(a, pc + 1 + Instruction.distance(w));
      case Op.JUMP -> code.goto_(label(pc + 1 + Instruction.distance(w)));
      case Op.LOOP -> turn(pc, pc + 1 + Instruction.distance(w), a);
      case Op.MARK -> registers.mark(Instruction.distance(w));
      case Op.JUMP_IF_FALSE -> jumpIf(pc, a, Opcode.IFEQ, pc + 1 + Instruction.distance(w));
      case Op.JUMP_IF_TRUE -> jumpIf(pc, a, Opcode.IFNE, pc + 1 + Instruction.distance(w));
      // a comparison with NaN counts as greater
      case Op.JUMP_IF_LESS -> jumpOrder(pc, a, b, Opcode.IFLT, label(pc + 1 + c));
      case Op.JUMP_IF_LESS_OR_EQUAL -> jumpOrder(pc, a, b, Opcode.IFLE, label(pc + 1 + c));
      case Op.JUMP_IF_NOT_LESS -> jumpOrder(pc, a, b, Opcode.IFGE, label(pc + 1 + c));
      case Op.JUMP_IF_NOT_LESS_OR_EQUAL -> jumpOrder(pc, a, b, Opcode.IFGT, label(pc + 1 + c));
      case Op.LOOP_IF_LESS -> loopOrder(pc, a, b, Opcode.IFGE, pc + 1 + c);
      case Op.LOOP_IF_LESS_OR_EQUAL -> loopOrder(pc, a, b, Opcode.IFGT, pc + 1 + c);
      case Op.JUMP_IF_EQUAL -> jumpEqual(pc, a, b, true, label(pc + 1 + c), label(pc + 1));
      case Op.JUMP_IF_NOT_EQUAL -> jumpEqual(pc, a, b, false, label(pc + 1 + c), label(pc + 1));
      case Op.CALL -> call(pc, Instruction.index(a), b, Instruction.index(c));
      case Op.RETURN -> giveBack(pc, a);
      case Op.RETURN_NONE -> registers.leave(0, () -> code.loadConstant(Registers.NONE));
      case Op.STRETCH -> stretch(pc);
      case Op.GET_INDEX -> getIndex(pc, a, b, c);
      case Op.GET_INDEX_2 -> getElement(pc, a, b, c);
      case Op.SET_INDEX -> setIndex(pc, a, b, c);
      case Op.SET_INDEX_2 -> setElement(pc, a, b, c);
      default -> general(pc, operation, a);
    }
  }

  /** Writes the rare cases. */
  void finish() {
    for (int i = 0; i < tail.size(); i++) {
      tail.get(i).run();
    }
    code.labelBinding(stopped);
    code.areturn();
  }

  /** The place of instruction {@code pc} in full generality; it changes {@code target}, if any. */
  private Label slow(int pc, int... target) {
    return rare(() -> registers.slow(pc), label(pc + 1), target);
  }

  /** The place where {@code call} executes an instruction, before {@code next} continues. */
  private Label rare(Runnable call, Label next, int... target) {
    Label label = code.newLabel();
    tail.add(
        () -> {
          code.labelBinding(label);
          call.run();
          stopUnlessGoesOn();
          for (int operand : target) {
            registers.reload(operand);
          }
          code.goto_(next);
        });
    return label;
  }

  /** Takes a {@link Stop} from the operand stack and returns it if it is one. */
  private void stopUnlessGoesOn() {
    code.dup();
    registers.stop(Stop.GOES_ON);
    code.if_acmpne(stopped).pop();
  }

  /** Operations that are always done in full generality. */
  private void general(int pc, int operation, int a) {
    if (operation == Op.CALL_BUILTIN) {
      registers.slowCall(pc);
    } else {
      registers.slow(pc);
    }
    switch (operation) {
      case Op.CALL_BUILTIN, Op.CALL_METHOD, Op.CALL_PART_METHOD, Op.RUN -> {
        stopUnlessGoesOn();
        registers.reloadArrays();
        registers.reload(a);
      }
      case Op.JOIN, Op.KILL, Op.ENTER_CRITICAL, Op.EXIT_CRITICAL -> stopUnlessGoesOn();
      case Op.HALT, Op.PAUSE, Op.INTERPRETED -> code.areturn();
      default -> {
        stopUnlessGoesOn();
        registers.reload(a);
      }
    }
  }

  // --- moves

  private void move(int pc, int target, int source, boolean copy) {
    int known = registers.knownTag(source);
    if (known == Registers.OBJECT && copy) {
      general(pc, Op.COPY, target);
    } else if (known == Registers.OBJECT) {
      registers.storeTag(target, () -> code.loadConstant(known));
      registers.copyObject(target, source);
    } else if (known >= 0) {
      registers.number(source);
      code.dstore(JvmCode.NUMBER);
      registers.store(target, () -> code.loadConstant(known));
    } else {
      registers.tag(source);
      code.dup().istore(JvmCode.TAG);
      Label slow = slow(pc, target);
      if (copy) {
        code.loadConstant(Registers.NONE).if_icmpgt(slow);
      } else {
        code.loadConstant(Registers.UNASSIGNED).if_icmpeq(slow);
      }
      registers.number(source);
      code.dstore(JvmCode.NUMBER);
      registers.store(target, () -> code.iload(JvmCode.TAG));
      if (!copy) {
        code.iload(JvmCode.TAG).loadConstant(Registers.OBJECT).if_icmpne(label(pc + 1));
        registers.copyObject(target, source);
      }
    }
  }

  private void assign(int pc, int target, int source) {
    Label fast = code.newLabel();
    Label slow = slow(pc, target);
    registers.tag(source);
    code.dup().istore(JvmCode.TAG);
    registers.tag(target);
    code.ior().iconst_1().if_icmple(fast);
    registers.tag(target);
    code.loadConstant(Registers.UNASSIGNED).if_icmpne(slow);
    code.iload(JvmCode.TAG).loadConstant(Registers.BOOL).if_icmpgt(slow);
    code.labelBinding(fast);
    registers.number(source);
    code.dstore(JvmCode.NUMBER);
    registers.store(target, () -> code.iload(JvmCode.TAG));
  }

  // --- arithmetic

  /** Pushes a tag that is at most FLOAT when both operands are numbers. */
  private void tags(int x, int y) {
    registers.tag(x);
    registers.tag(y);
    code.ior();
  }

  /** Adds to the tag on the stack what keeps a number from being stored into {@code target}. */
  private void targetTag(int target) {
    if (registers.isVariable(target)) {
      registers.tag(target);
      code.loadConstant(Processor.NOT_FOR_NUMBER).iand().ior();
    }
  }

  private void arithmetic(int pc, int operation, int target, int x, int y) {
    Label slow =
        operation == Op.ADD
            ? rare(() -> registers.slowAdd(pc), label(pc + 1), target)
            : slow(pc, target);
    boolean isFloat =
        registers.knownTag(x) == Registers.FLOAT || registers.knownTag(y) == Registers.FLOAT;
    tags(x, y);
    if (!isFloat) {
      code.dup().istore(JvmCode.TAG);
    }
    targetTag(target);
    code.iconst_1().if_icmpgt(slow);
    registers.number(x);
    registers.number(y);
    switch (operation) {
      case Op.ADD -> code.dadd();
      case Op.SUBTRACT -> code.dsub();
      default -> code.dmul();
    }
    code.dstore(JvmCode.NUMBER);
    storeNumber(target, slow, isFloat, operation == Op.MULTIPLY);
  }

  /**
   * Stores the number in {@link JvmCode#NUMBER} if it is what its tag says.
   *
   * @param signedZero whether an int can come out as the negative zero that it does not have
   */
  private void storeNumber(int target, Label slow, boolean isFloat, boolean signedZero) {
    if (isFloat) {
      registers.store(target, () -> code.loadConstant(Registers.FLOAT));
      return;
    }
    Label fits = code.newLabel();
    code.iload(JvmCode.TAG).ifne(fits);
    code.dload(JvmCode.NUMBER).dup2().d2i().i2d().dcmpl().ifne(slow);
    if (signedZero) {
      code.dload(JvmCode.NUMBER).dconst_0().dadd().dstore(JvmCode.NUMBER);
    }
    code.labelBinding(fits);
    registers.store(target, () -> code.iload(JvmCode.TAG));
  }

  private void divide(int pc, int target, int x, int y) {
    Label slow = slow(pc, target);
    tags(x, y);
    targetTag(target);
    code.iconst_1().if_icmpgt(slow);
    registers.number(y);
    code.dconst_0().dcmpl().ifeq(slow);
    registers.number(x);
    registers.number(y);
    code.ddiv().dstore(JvmCode.NUMBER);
    registers.store(target, () -> code.loadConstant(Registers.FLOAT));
  }

  private void modulo(int pc, int target, int x, int y) {
    Label slow = slow(pc, target);
    tags(x, y);
    targetTag(target);
    code.ifne(slow);
    registers.number(y);
    code.dconst_0().dcmpl().ifeq(slow);
    registers.number(x);
    code.d2i();
    registers.number(y);
    code.d2i().irem().i2d().dstore(JvmCode.NUMBER);
    registers.store(target, () -> code.loadConstant(Registers.INT));
  }

  private void negate(int pc, int target, int x) {
    Label slow = slow(pc, target);
    registers.tag(x);
    code.dup().istore(JvmCode.TAG);
    targetTag(target);
    code.iconst_1().if_icmpgt(slow);
    registers.number(x);
    code.dneg().dstore(JvmCode.NUMBER);
    storeNumber(target, slow, false, true);
  }

  // --- truth

  /** Stores 1 after a jump to {@code one} and 0 otherwise. */
  private void storeTruth(int target, Label zero, Label one) {
    Label done = code.newLabel();
    code.labelBinding(zero);
    code.dconst_0().dstore(JvmCode.NUMBER).goto_(done);
    code.labelBinding(one);
    code.dconst_1().dstore(JvmCode.NUMBER);
    code.labelBinding(done);
    registers.store(target, () -> code.loadConstant(Registers.BOOL));
  }

  private void equal(int pc, int target, int x, int y, boolean when) {
    Label zero = code.newLabel();
    Label one = code.newLabel();
    jumpEqual(pc, x, y, when, one, zero);
    storeTruth(target, zero, one);
  }

  private void jumpEqual(int pc, int x, int y, boolean when, Label target, Label otherwise) {
    Label slow = code.newLabel();
    tags(x, y);
    code.iconst_1().if_icmpgt(slow);
    registers.number(x);
    registers.number(y);
    code.dcmpl().branch(when ? Opcode.IFEQ : Opcode.IFNE, target);
    tail.add(
        () -> {
          Label stops = code.newLabel();
          code.labelBinding(slow);
          registers.slowEqual(pc);
          code.dup().iflt(stops);
          code.branch(when ? Opcode.IFNE : Opcode.IFEQ, target).goto_(otherwise);
          code.labelBinding(stops).pop();
          registers.stop(Stop.EXHAUSTED);
          code.areturn();
        });
  }

  private void jumpOrder(int pc, int x, int y, Opcode when, Label target) {
    tags(x, y);
    code.iconst_1().if_icmpgt(slow(pc));
    registers.number(x);
    registers.number(y);
    code.dcmpg().branch(when, target);
  }

  private void order(int pc, int target, int x, int y, Opcode when) {
    Label zero = code.newLabel();
    Label one = code.newLabel();
    jumpOrder(pc, x, y, when, one);
    storeTruth(target, zero, one);
  }

  private void loopOrder(int pc, int x, int y, Opcode unless, int target) {
    jumpOrder(pc, x, y, unless, label(pc + 1));
    turn(pc, target, 0);
  }

  /**
   * Jumps back from instruction {@code pc}.
   *
   * @param free how many instructions in between cost nothing
   */
  private void turn(int pc, int target, int free) {
    Label exhausted = code.newLabel();
    Label direct = code.newLabel();
    registers.count(Cost.turn(pc + 1 - target - free), exhausted);
    registers.countTurn(direct);
    code.goto_(label(target));
    tail.add(
        () -> {
          code.labelBinding(exhausted);
          registers.exhausted(target);
          code.labelBinding(direct);
          registers.loop(target);
          registers.refusal();
          code.areturn();
        });
  }

  private void stretch(int pc) {
    Label exhausted = code.newLabel();
    registers.count(Cost.STRETCH_NS, exhausted);
    tail.add(
        () -> {
          code.labelBinding(exhausted);
          registers.exhausted(pc + 1);
        });
  }

  private void jumpIf(int pc, int operand, Opcode when, int target) {
    truth(pc, operand);
    code.branch(when, label(target));
  }

  private void jumpIfGiven(int parameter, int target) {
    registers.tag(parameter);
    code.loadConstant(Registers.UNASSIGNED).if_icmpne(label(target));
  }

  /**
   * Pushes 0 if the operand of instruction {@code pc} is false; that of a string is found first.
   */
  private void truth(int pc, int operand) {
    Label found = code.newLabel();
    registers.tag(operand);
    code.loadConstant(Registers.BOOL).if_icmpgt(rare(() -> registers.slow(pc), found, operand));
    code.labelBinding(found);
    registers.number(operand);
    code.dconst_0().dcmpl();
  }

  private void not(int pc, int target, int x) {
    Label zero = code.newLabel();
    Label one = code.newLabel();
    truth(pc, x);
    code.ifeq(one);
    storeTruth(target, zero, one);
  }

  // --- elements

  private void getIndex(int pc, int target, int list, int index) {
    Label slow = slow(pc, target);
    registers.tag(list);
    code.loadConstant(Registers.OBJECT).if_icmpne(slow);
    registers.tag(index);
    code.ifne(slow);
    if (registers.isVariable(target)) {
      registers.tag(target);
      code.loadConstant(Processor.NOT_FOR_NUMBER).iand().ifne(slow);
    }
    registers.object(list);
    registers.number(index);
    code.invokestatic(
            JvmCode.CODE,
            "numbersAt",
            MethodTypeDesc.of(JvmCode.LIST, JvmCode.VALUE, ConstantDescs.CD_double))
        .dup()
        .astore(JvmCode.CONTAINER)
        .ifnull(slow);
    code.aload(JvmCode.CONTAINER)
        .invokevirtual(JvmCode.LIST, "tag", MethodTypeDesc.of(ConstantDescs.CD_int))
        .istore(JvmCode.TAG)
        .aload(JvmCode.CONTAINER);
    registers.number(index);
    code.d2i()
        .invokevirtual(
            JvmCode.LIST,
            "numberAt",
            MethodTypeDesc.of(ConstantDescs.CD_double, ConstantDescs.CD_int))
        .dstore(JvmCode.NUMBER);
    registers.store(target, () -> code.iload(JvmCode.TAG));
  }

  /** An element of a matrix; its target is always a temporary. */
  private void getElement(int pc, int target, int matrix, int row) {
    int column = row + 1;
    Label slow = slow(pc, target);
    registers.tag(matrix);
    code.loadConstant(Registers.OBJECT).if_icmpne(slow);
    registers.tag(row);
    code.ifne(slow);
    registers.tag(column);
    code.ifne(slow);
    registers.object(matrix);
    registers.number(row);
    registers.number(column);
    code.invokestatic(
            JvmCode.CODE,
            "matrixAt",
            MethodTypeDesc.of(
                JvmCode.MATRIX, JvmCode.VALUE, ConstantDescs.CD_double, ConstantDescs.CD_double))
        .dup()
        .astore(JvmCode.CONTAINER)
        .ifnull(slow);
    code.aload(JvmCode.CONTAINER)
        .invokevirtual(JvmCode.MATRIX, "tag", MethodTypeDesc.of(ConstantDescs.CD_int))
        .istore(JvmCode.TAG)
        .aload(JvmCode.CONTAINER);
    registers.number(row);
    code.d2i();
    registers.number(column);
    code.d2i()
        .invokevirtual(
            JvmCode.MATRIX,
            "numberAt",
            MethodTypeDesc.of(ConstantDescs.CD_double, ConstantDescs.CD_int, ConstantDescs.CD_int))
        .dstore(JvmCode.NUMBER);
    registers.store(target, () -> code.iload(JvmCode.TAG));
  }

  private void setIndex(int pc, int list, int index, int element) {
    Label slow = slow(pc, list);
    registers.tag(list);
    code.loadConstant(Registers.OBJECT).if_icmpne(slow);
    registers.tag(index);
    code.ifne(slow);
    registers.object(list);
    registers.number(index);
    registers.tag(element);
    registers.number(element);
    code.invokestatic(
            JvmCode.CODE,
            "storeAt",
            MethodTypeDesc.of(
                ConstantDescs.CD_boolean,
                JvmCode.VALUE,
                ConstantDescs.CD_double,
                ConstantDescs.CD_int,
                ConstantDescs.CD_double))
        .ifeq(slow);
  }

  private void setElement(int pc, int matrix, int row, int element) {
    int column = row + 1;
    Label slow = slow(pc, matrix);
    registers.tag(matrix);
    code.loadConstant(Registers.OBJECT).if_icmpne(slow);
    registers.tag(row);
    code.ifne(slow);
    registers.tag(column);
    code.ifne(slow);
    registers.object(matrix);
    registers.number(row);
    registers.number(column);
    registers.tag(element);
    registers.number(element);
    code.invokestatic(
            JvmCode.CODE,
            "storeAt",
            MethodTypeDesc.of(
                ConstantDescs.CD_boolean,
                JvmCode.VALUE,
                ConstantDescs.CD_double,
                ConstantDescs.CD_double,
                ConstantDescs.CD_int,
                ConstantDescs.CD_double))
        .ifeq(slow);
  }

  // --- calls

  private void call(int pc, int result, int number, int offset) {
    Label refused = code.newLabel();
    registers.enter(pc, number, offset, result);
    code.dup().astore(JvmCode.CALLEE).ifnull(refused);
    registers.runCallee();
    code.dup();
    registers.stop(Stop.RETURNED);
    code.if_acmpne(stopped).pop();
    registers.returned(Instruction.local(result));
    tail.add(
        () -> {
          code.labelBinding(refused);
          registers.refusal();
          code.areturn();
        });
  }

  private void giveBack(int pc, int operand) {
    int known = registers.knownTag(operand);
    if (known >= 0) {
      registers.leave(operand, () -> code.loadConstant(known));
      return;
    }
    registers.tag(operand);
    code.dup().istore(JvmCode.TAG).loadConstant(Registers.UNASSIGNED).if_icmpeq(slow(pc));
    registers.leave(operand, () -> code.iload(JvmCode.TAG));
  }
}
