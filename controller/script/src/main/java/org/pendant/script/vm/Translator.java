package org.pendant.script.vm;

import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.classfile.instruction.SwitchCase;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * Translator: translates the instructions of one function to a {@link TranslatedCode}. The common
 * case of an instruction becomes bytecode; the rare ones call {@link SlowPath}, from behind the
 * method's straight way.
 */
final class Translator {
  /** The JVM does not compile methods of more bytes than this. */
  private static final int LARGEST = 8000;

  /** A function of more instructions is too large in any case. */
  private static final int MAX_INSTRUCTIONS = 600;

  private final ScriptFunction function;
  private final long[] instructions;
  private final CodeBuilder code;
  private final JvmCode registers;
  private final InstructionTranslator translator;

  private Translator(CodeBuilder code, ScriptFunction function, Program.Tables tables) {
    this.function = function;
    this.instructions = function.instructions();
    this.code = code;
    registers = new JvmCode(code, function, tables, uses());
    translator = new InstructionTranslator(registers, instructions.length);
  }

  /**
   * The translation of {@code function}; empty when it is too large.
   *
   * @param tables what the static slots of its program hold
   */
  static Optional<TranslatedCode> translate(ScriptFunction function, Program.Tables tables) {
    if (function.paid() > MAX_INSTRUCTIONS) {
      return Optional.empty();
    }
    byte[] bytes =
        ClassFile.of()
            .build(
                ClassDesc.of(TranslatedCode.class.getPackageName(), "TranslatedFunction"),
                type ->
                    type.withSuperclass(JvmCode.CODE)
                        .withFlags(ClassFile.ACC_FINAL | ClassFile.ACC_SUPER)
                        .withMethodBody(
                            ConstantDescs.INIT_NAME,
                            ConstantDescs.MTD_void,
                            0,
                            code ->
                                code.aload(0)
                                    .invokespecial(
                                        JvmCode.CODE,
                                        ConstantDescs.INIT_NAME,
                                        ConstantDescs.MTD_void)
                                    .return_())
                        .withMethodBody(
                            "run",
                            JvmCode.RUN,
                            0,
                            code -> new Translator(code, function, tables).write()));
    return HiddenClass.largestMethod(bytes) > LARGEST
        ? Optional.empty()
        : Optional.of(HiddenClass.make(bytes, TranslatedCode.class));
  }

  /** How often each local slot is read as a number, or has its tag looked at. */
  private int[] uses() {
    int[] uses = new int[function.slotCount()];
    for (long w : instructions) {
      for (int operand : InstructionTranslator.numbers(w)) {
        if (Instruction.isLocal(operand)) {
          uses[Instruction.index(operand)]++;
        }
      }
    }
    return uses;
  }

  /** Where the code can be entered, apart from the start. */
  private SortedSet<Integer> resumePoints() {
    SortedSet<Integer> points = new TreeSet<>(LoopInstructions.waysOut(instructions));
    for (int pc = 0; pc < instructions.length; pc++) {
      long w = instructions[pc];
      switch (Instruction.operation(w)) {
        case Op.LOOP -> points.add(pc + 1 + Instruction.distance(w));
        case Op.LOOP_IF_LESS, Op.LOOP_IF_LESS_OR_EQUAL -> points.add(pc + 1 + Instruction.c(w));
        case Op.CALL -> {
          // the budget may end before it is counted
          points.add(pc);
          points.add(pc + 1);
        }
        case Op.CALL_BUILTIN, Op.CALL_METHOD, Op.CALL_PART_METHOD, Op.JOIN, Op.PAUSE, Op.STRETCH ->
            points.add(pc + 1);
        default -> {}
      }
    }
    points.remove(0);
    return points;
  }

  private void write() {
    registers.prologue(translator.label(0));
    List<SwitchCase> cases = new ArrayList<>();
    for (int point : resumePoints()) {
      cases.add(SwitchCase.of(point, translator.label(point)));
    }
    Label unknown = code.newLabel();
    if (!cases.isEmpty()) {
      code.iload(JvmCode.PC).lookupswitch(unknown, cases);
    }
    code.labelBinding(unknown);
    registers.unknownResumePoint();
    for (int pc = 0; pc < instructions.length; pc++) {
      code.labelBinding(translator.label(pc));
      translator.translate(pc, instructions[pc]);
    }
    translator.finish();
  }
}
