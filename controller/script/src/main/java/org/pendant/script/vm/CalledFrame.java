package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.List;

/**
 * Called frame: a function that is called directly. There is no frame of it before it is left, when
 * {@link LeftFrames} notes it.
 */
final class CalledFrame implements DirectFrame {
  private static final ClassDesc LEFT_FRAMES = JvmCode.desc(LeftFrames.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final MethodTypeDesc FRAME =
      MethodTypeDesc.of(ConstantDescs.CD_void, INT, INT, INT);
  private static final MethodTypeDesc SLOT =
      MethodTypeDesc.of(ConstantDescs.CD_void, INT, INT, ConstantDescs.CD_double);

  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectSlots slots;
  private final List<Runnable> tail;

  /**
   * @param tail what is written behind all instructions
   */
  CalledFrame(CodeBuilder code, DirectForm form, DirectSlots slots, List<Runnable> tail) {
    this.code = code;
    this.form = form;
    this.slots = slots;
    this.tail = tail;
  }

  /** Counts the call, if it can be begun. */
  @Override
  public void begin() {
    Label refused = code.newLabel();
    code.aload(DirectSlots.THREAD).getfield(JvmCode.THREAD, "budget", INT).iflt(refused);
    code.iload(DirectSlots.ROOM).iflt(refused);
    slots.loadBudget();
    slots.count(form.function().callNs());
    slots.convert(form.given(), form.state(0));
    tail.add(
        () -> {
          code.labelBinding(refused);
          slots.leftFrames();
          code.invokevirtual(LEFT_FRAMES, "refuse", ConstantDescs.MTD_void);
          slots.returnLeft();
        });
  }

  @Override
  public void leave(int[] state) {
    slots.leftFrames();
    code.dup()
        .astore(slots.leftVariable)
        .loadConstant(form.number())
        .iload(slots.pcVariable)
        .iload(slots.howVariable)
        .invokevirtual(LEFT_FRAMES, "frame", FRAME);
    // global variables are in the registers
    for (int i = 0; i < form.function().slotCount(); i++) {
      if (state[i] != 0) {
        code.aload(slots.leftVariable).loadConstant(i);
        slots.pushSlotTag(i, state[i]);
        slots.pushNumber(i, state[i]);
        code.invokevirtual(LEFT_FRAMES, "slot", SLOT);
      }
    }
    slots.returnLeft();
  }
}
