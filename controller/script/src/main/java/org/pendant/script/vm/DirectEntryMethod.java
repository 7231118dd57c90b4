package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;

/** Direct entry method: takes arguments from registers, and puts the result there. */
final class DirectEntryMethod {
  private static final ClassDesc LEFT_FRAMES = JvmCode.desc(LeftFrames.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final ClassDesc DOUBLE = ConstantDescs.CD_double;
  private static final ClassDesc BOOLEAN = ConstantDescs.CD_boolean;

  /** The type of {@link DirectCode#call}. */
  static final MethodTypeDesc CALL =
      MethodTypeDesc.of(
          BOOLEAN,
          JvmCode.THREAD,
          INT,
          DOUBLE.arrayType(),
          ConstantDescs.CD_byte.arrayType(),
          INT,
          INT);

  private DirectEntryMethod() {}

  /** Writes {@link DirectCode#call} for {@code form}. */
  static void write(CodeBuilder code, DirectForm form, DirectUnit unit) {
    int thread = 1;
    int numbers = 3;
    int tags = 4;
    int first = 5;
    int target = 6;
    int number = 7;
    code.aload(thread).iload(2);
    for (int i = 0; i < form.function().parameterCount(); i++) {
      DirectSlots.Kept kept = DirectSlots.Kept.of(form.parameter(i));
      if (kept == DirectSlots.Kept.NOT) {
        continue;
      }
      code.aload(numbers).iload(first).loadConstant(i).iadd().daload();
      if (kept == DirectSlots.Kept.LONG) {
        code.d2l();
      } else if (kept == DirectSlots.Kept.TAGGED) {
        code.aload(tags).iload(first).loadConstant(i).iadd().baload();
      }
    }
    Label left = code.newLabel();
    code.invokestatic(DirectUnit.SELF, unit.method(form), DirectSlots.type(form));
    if (DirectSlots.returnsLong(form)) {
      code.dup2().loadConstant(DirectSlots.LEFT).lcmp().ifeq(left).l2d().dstore(number);
    } else {
      code.dstore(number);
      Label valid = code.newLabel();
      code.dload(number).dload(number).dcmpl().ifeq(valid);
      code.aload(thread)
          .getfield(JvmCode.THREAD, "left", LEFT_FRAMES)
          .getfield(LEFT_FRAMES, "leaving", BOOLEAN)
          .ifeq(valid)
          .iconst_0()
          .ireturn();
      code.labelBinding(valid);
    }
    code.aload(numbers).iload(target).dload(number).dastore();
    code.aload(tags).iload(target);
    if (TagSet.single(form.result())) {
      code.loadConstant(TagSet.tag(form.result()));
    } else {
      code.aload(thread).getfield(JvmCode.THREAD, "resultTag", INT);
    }
    code.bastore().iconst_1().ireturn();
    if (DirectSlots.returnsLong(form)) {
      code.labelBinding(left).pop2().iconst_0().ireturn();
    }
  }
}
