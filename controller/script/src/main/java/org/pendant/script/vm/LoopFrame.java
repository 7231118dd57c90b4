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
  private static final ClassDesc INT = ConstantDescs.CD_int;

  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectSlots slots;
  private final DirectRegisters registers;
  private final LoopRegion loop;
  private final Label[] labels;

  /**
   * @param labels the place of each instruction
   */
  LoopFrame(
      CodeBuilder code,
      DirectForm form,
      DirectSlots slots,
      DirectRegisters registers,
      LoopRegion loop,
      Label[] labels) {
    this.code = code;
    this.form = form;
    this.slots = slots;
    this.registers = registers;
    this.loop = loop;
    this.labels = labels;
  }

  @Override
  public void begin() {
    slots.loadBudget();
    int[] given = form.given();
    for (int i = 0; i < given.length; i++) {
      registers.load(i, given[i]);
    }
    slots.convert(given, form.state(loop.head()));
    code.goto_(labels[loop.head()]);
  }

  @Override
  public void leave(int[] state) {
    for (int i = 0; i < state.length; i++) {
      if (TagSet.mayBeWritten(state[i]) && loop.writes(i)) {
        registers.store(i, state[i]);
      }
    }
    slots.leftFrames();
    code.iload(slots.pcVariable)
        .iload(slots.howVariable)
        .invokevirtual(LEFT_FRAMES, "loop", MethodTypeDesc.of(ConstantDescs.CD_void, INT, INT));
    slots.returnLeft();
  }
}
