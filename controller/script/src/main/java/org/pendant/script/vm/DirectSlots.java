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

  // parameters of loops
  private static final int NUMBERS = 2;
  private static final int TAGS = 3;
  private static final int OBJECTS = 4;
  static final int BASE = 5;

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

  /** Index of an element. */
  final int indexVariable;

  /** Where the row of an element begins. */
  final int rowVariable;

  /** The array of elements of each list or matrix; 0 for none. */
  final int[] elements;

  /** The budget of the thread, where a function has loops; else it is only found in the thread. */
  private final int budgetVariable;

  private final boolean counts;

  /** Where coverage is marked. */
  private final int marksVariable;

  // arrays of the registers
  final int registerNumbers;
  final int registerTags;
  final int registerObjects;

  DirectSlots(CodeBuilder code, DirectForm form) {
    this.code = code;
    this.form = form;
    int slots = form.given().length;
    longs = new int[slots];
    doubles = new int[slots];
    tagVariables = new int[slots];
    elements = new int[slots];
    int next = form.loop().isPresent() ? BASE + 1 : FIRST_PARAMETER;
    for (int i = 0; i < form.parameterCount(); i++) {
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
      if (form.given()[i] > TagSet.MAX) {
        elements[i] = next;
        next += 4;
      }
    }
    numberVariable = next;
    pcVariable = next + 2;
    howVariable = next + 3;
    tagVariable = next + 4;
    leftVariable = next + 5;
    budgetVariable = next + 6;
    indexVariable = next + 7;
    rowVariable = next + 8;
    marksVariable = next + 9;
    registerNumbers = form.loop().isPresent() ? NUMBERS : next + 10;
    registerTags = form.loop().isPresent() ? TAGS : next + 11;
    registerObjects = form.loop().isPresent() ? OBJECTS : next + 12;
    counts = Arrays.stream(form.function().instructions()).anyMatch(JvmCode::isCounted);
  }

  /** The type of the method of {@code form}. */
  static MethodTypeDesc type(DirectForm form) {
    if (form.loop().isPresent()) {
      return DirectUnit.LOOP;
    }
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

  /** The length of a list, or the rows of a matrix. */
  int length(int slot) {
    return elements[slot] + 1;
  }

  /** The columns of a matrix. */
  int columns(int slot) {
    return elements[slot] + 2;
  }

  /** Whether nobody else has the elements of a list or matrix. */
  int owned(int slot) {
    return elements[slot] + 3;
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
    pushSlotTag(form.slot(operand), form.tags(operand, state));
  }

  void pushSlotTag(int slot, int tags) {
    if (TagSet.single(tags)) {
      code.loadConstant(TagSet.tag(tags));
    } else {
      code.iload(tagVariables[slot]);
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
    int slot = form.slot(operand);
    if (slot < 0) {
      code.loadConstant(form.constant(operand));
    } else {
      pushNumber(slot, state[slot]);
    }
  }

  void pushLong(int operand, int[] state) {
    int slot = form.slot(operand);
    if (slot < 0) {
      code.loadConstant((long) form.constant(operand));
    } else if (Kept.of(state[slot]) == Kept.LONG) {
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

  // --- coverage

  void loadMarks() {
    if (Arrays.stream(form.function().instructions())
        .anyMatch(w -> Instruction.operation(w) == Op.MARK)) {
      code.aload(THREAD)
          .getfield(JvmCode.THREAD, "marks", ConstantDescs.CD_byte.arrayType())
          .astore(marksVariable);
    }
  }

  /** Marks coverage {@code slot} as reached. */
  void mark(int slot) {
    code.aload(marksVariable).loadConstant(slot).iconst_1().bastore();
  }

  // --- ways out

  void leftFrames() {
    code.aload(THREAD).getfield(JvmCode.THREAD, "left", LEFT_FRAMES);
  }

  void returnLeft() {
    if (form.loop().isPresent()) {
      code.return_();
    } else if (returnsLong(form)) {
      code.loadConstant(LEFT).lreturn();
    } else {
      code.loadConstant(Double.NaN).dreturn();
    }
  }
}
