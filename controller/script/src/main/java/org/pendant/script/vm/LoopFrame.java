package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;

/**
 * Loop frame: a frame of the thread that a loop goes on in directly. Its variables are loaded from
 * the registers, and what may have changed is written back when it is left.
 */
final class LoopFrame implements DirectFrame {
  private static final ClassDesc LEFT_FRAMES = JvmCode.desc(LeftFrames.class);
  private static final ClassDesc LOOP_CODE = JvmCode.desc(LoopCode.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final ClassDesc DOUBLE = ConstantDescs.CD_double;
  private static final ClassDesc DOUBLES = DOUBLE.arrayType();
  private static final MethodTypeDesc STORE =
      MethodTypeDesc.of(
          ConstantDescs.CD_void, DOUBLES, ConstantDescs.CD_byte.arrayType(), INT, DOUBLE, INT);
  private static final MethodTypeDesc GIVES_INT = MethodTypeDesc.of(INT);

  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectSlots slots;
  private final LoopRegion loop;
  private final Label[] labels;

  /**
   * @param labels the place of each instruction
   */
  LoopFrame(CodeBuilder code, DirectForm form, DirectSlots slots, LoopRegion loop, Label[] labels) {
    this.code = code;
    this.form = form;
    this.slots = slots;
    this.loop = loop;
    this.labels = labels;
  }

  @Override
  public void begin() {
    slots.loadBudget();
    int[] given = form.given();
    for (int i = 0; i < given.length; i++) {
      if (given[i] > TagSet.MAX) {
        loadElements(i, given[i]);
      } else {
        load(i, DirectSlots.Kept.of(given[i]));
      }
    }
    slots.convert(given, form.state(loop.head()));
    code.goto_(labels[loop.head()]);
  }

  private void address(int slot) {
    int globals = form.function().slotCount();
    if (slot >= globals) {
      code.loadConstant(Instruction.index(loop.globals()[slot - globals]));
    } else {
      code.iload(DirectSlots.BASE).loadConstant(slot).iadd();
    }
  }

  private void load(int slot, DirectSlots.Kept kept) {
    if (kept != DirectSlots.Kept.NOT) {
      code.aload(DirectSlots.NUMBERS);
      address(slot);
      code.daload();
    }
    switch (kept) {
      case NOT -> {}
      case LONG -> code.d2l().lstore(slots.longs[slot]);
      case DOUBLE -> code.dstore(slots.doubles[slot]);
      case TAGGED -> throw new IllegalStateException("a variable has one tag");
    }
  }

  /** Takes over the elements of a list or matrix: nothing in a loop gives it others. */
  private void loadElements(int slot, int kind) {
    boolean list = (kind & TagSet.LIST) != 0;
    ClassDesc type = list ? JvmCode.LIST : JvmCode.MATRIX;
    code.aload(DirectSlots.OBJECTS);
    address(slot);
    code.aaload().checkcast(type).astore(slots.leftVariable);
    code.aload(slots.leftVariable)
        .invokevirtual(type, "elements", MethodTypeDesc.of(DOUBLES))
        .astore(slots.elements[slot]);
    code.aload(slots.leftVariable)
        .invokevirtual(type, list ? "length" : "rows", GIVES_INT)
        .istore(slots.length(slot));
    if (!list) {
      code.aload(slots.leftVariable)
          .invokevirtual(type, "columns", GIVES_INT)
          .istore(slots.columns(slot));
    }
    code.aload(slots.leftVariable)
        .invokevirtual(type, "shared", MethodTypeDesc.of(ConstantDescs.CD_boolean))
        .iconst_1()
        .ixor()
        .istore(slots.owned(slot));
  }

  @Override
  public void leave(int[] state) {
    for (int i = 0; i < state.length; i++) {
      if (TagSet.mayBeWritten(state[i]) && loop.writes(i)) {
        code.aload(DirectSlots.NUMBERS).aload(DirectSlots.TAGS);
        address(i);
        slots.pushNumber(i, state[i]);
        slots.pushSlotTag(i, state[i]);
        code.invokestatic(LOOP_CODE, "store", STORE);
      }
    }
    slots.leftFrames();
    code.iload(slots.pcVariable)
        .iload(slots.howVariable)
        .invokevirtual(LEFT_FRAMES, "loop", MethodTypeDesc.of(ConstantDescs.CD_void, INT, INT));
    slots.returnLeft();
  }
}
