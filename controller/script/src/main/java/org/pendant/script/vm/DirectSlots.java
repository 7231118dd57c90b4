package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Direct slots: where a method of {@link DirectCode} keeps the slots of its function and the
 * budget.
 *
 * <p>A slot of which it is known that it holds an int or bool is a long, one that holds a float a
 * double, and one that can have several tags a double and its tag. Every method returns a result in
 * the same way, where a tag stands in the thread, or {@link #LEFT} or NaN when it was left.
 */
final class DirectSlots {
  private static final ClassDesc LEFT_FRAMES = JvmCode.desc(LeftFrames.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final ClassDesc LONG = ConstantDescs.CD_long;
  private static final ClassDesc DOUBLE = ConstantDescs.CD_double;

  /** What a method that returns a long returns when it was left: no int. */
  static final long LEFT = Long.MIN_VALUE;

  static final int THREAD = 0;
  static final int ROOM = 1;
  private static final int FIRST_PARAMETER = 2;

  /** How values of some tags are kept. */
  enum Kept {
    NOT,
    LONG,
    DOUBLE,
    TAGGED;

    static Kept of(int tags) {
      if (tags == TagSet.INT || tags == TagSet.BOOL) {
        return LONG;
      }
      if (tags == TagSet.FLOAT) {
        return DOUBLE;
      }
      return tags == 0 || TagSet.single(tags) ? NOT : TAGGED;
    }
  }

  private final CodeBuilder code;
  private final DirectForm form;

  final int[] longs;
  final int[] doubles;
  final int[] tagVariables;
  final int pcVariable;
  final int howVariable;
  final int numberVariable;
  final int tagVariable;
  final int leftVariable;

  /** The budget of the thread, where a function has loops; else it is only found in the thread. */
  private final int budgetVariable;

  private final boolean counts;

  DirectSlots(CodeBuilder code, DirectForm form) {
    this.code = code;
    this.form = form;
    int slots = form.function().slotCount();
    longs = new int[slots];
    doubles = new int[slots];
    tagVariables = new int[slots];
    int next = FIRST_PARAMETER;
    for (int i = 0; i < form.function().parameterCount(); i++) {
      switch (Kept.of(form.parameter(i))) {
        case NOT -> {}
        case LONG -> {
          longs[i] = next;
          next += 2;
        }
        case DOUBLE -> {
          doubles[i] = next;
          next += 2;
        }
        case TAGGED -> {
          doubles[i] = next;
          tagVariables[i] = next + 2;
          next += 3;
        }
      }
    }
    for (int i = 0; i < slots; i++) {
      if (longs[i] == 0) {
        longs[i] = next;
        next += 2;
      }
      if (doubles[i] == 0) {
        doubles[i] = next;
        next += 2;
      }
      if (tagVariables[i] == 0) {
        tagVariables[i] = next++;
      }
    }
    numberVariable = next;
    pcVariable = next + 2;
    howVariable = next + 3;
    tagVariable = next + 4;
    leftVariable = next + 5;
    budgetVariable = next + 6;
    counts = Arrays.stream(form.function().instructions()).anyMatch(JvmCode::isCounted);
  }

  /** The type of the method of {@code form}. */
  static MethodTypeDesc type(DirectForm form) {
    List<ClassDesc> parameters = new ArrayList<>(List.of(JvmCode.THREAD, INT));
    for (int i = 0; i < form.function().parameterCount(); i++) {
      switch (Kept.of(form.parameter(i))) {
        case NOT -> {}
        case LONG -> parameters.add(LONG);
        case DOUBLE -> parameters.add(DOUBLE);
        case TAGGED -> {
          parameters.add(DOUBLE);
          parameters.add(INT);
        }
      }
    }
    return MethodTypeDesc.of(returnsLong(form) ? LONG : DOUBLE, parameters);
  }

  static boolean returnsLong(DirectForm form) {
    Kept kept = Kept.of(form.result());
    return kept == Kept.LONG || kept == Kept.NOT;
  }

  /** Keeps the slots as the next instruction expects them. */
  void convert(int[] from, int[] to) {
    for (int i = 0; i < to.length; i++) {
      if (Kept.of(to[i]) == Kept.TAGGED && Kept.of(from[i]) != Kept.TAGGED) {
        pushNumber(i, from[i]);
        code.dstore(doubles[i]).loadConstant(TagSet.tag(from[i])).istore(tagVariables[i]);
      }
    }
  }

  boolean converts(int[] from, int[] to) {
    for (int i = 0; i < to.length; i++) {
      if (Kept.of(to[i]) == Kept.TAGGED && Kept.of(from[i]) != Kept.TAGGED) {
        return true;
      }
    }
    return false;
  }

  // --- operands

  void pushTag(int operand, int[] state) {
    int tags = form.tags(operand, state);
    if (TagSet.single(tags)) {
      code.loadConstant(TagSet.tag(tags));
    } else {
      code.iload(tagVariables[Instruction.index(operand)]);
    }
  }

  void pushNumber(int slot, int tags) {
    switch (Kept.of(tags)) {
      case LONG -> code.lload(longs[slot]).l2d();
      case DOUBLE, TAGGED -> code.dload(doubles[slot]);
      case NOT -> code.dconst_0();
    }
  }

  void pushDouble(int operand, int[] state) {
    if (!Instruction.isLocal(operand)) {
      code.loadConstant(form.constant(operand));
    } else {
      int slot = Instruction.index(operand);
      pushNumber(slot, state[slot]);
    }
  }

  void pushLong(int operand, int[] state) {
    if (!Instruction.isLocal(operand)) {
      code.loadConstant((long) form.constant(operand));
      return;
    }
    int slot = Instruction.index(operand);
    if (Kept.of(state[slot]) == Kept.LONG) {
      code.lload(longs[slot]);
    } else {
      code.dload(doubles[slot]).d2l();
    }
  }

  // --- the budget

  void loadBudget() {
    if (counts) {
      code.aload(THREAD).getfield(JvmCode.THREAD, "budget", INT).istore(budgetVariable);
    }
  }

  void writeBudgetBack() {
    if (counts) {
      code.aload(THREAD).iload(budgetVariable).putfield(JvmCode.THREAD, "budget", INT);
    }
  }

  void count(int costNs) {
    if (counts) {
      code.iinc(budgetVariable, -costNs);
      return;
    }
    code.aload(THREAD)
        .dup()
        .getfield(JvmCode.THREAD, "budget", INT)
        .loadConstant(costNs)
        .isub()
        .putfield(JvmCode.THREAD, "budget", INT);
  }

  void count(int costNs, Label exhausted) {
    count(costNs);
    code.iload(budgetVariable).iflt(exhausted);
  }

  void leftFrames() {
    code.aload(THREAD).getfield(JvmCode.THREAD, "left", LEFT_FRAMES);
  }

  void returnLeft() {
    if (returnsLong(form)) {
      code.loadConstant(LEFT).lreturn();
    } else {
      code.loadConstant(Double.NaN).dreturn();
    }
  }
}
