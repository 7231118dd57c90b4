package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;

/**
 * Direct registers: loads slots of a {@link DirectForm} from the registers, and writes them back.
 */
final class DirectRegisters {
  private static final ClassDesc LOOP_CODE = JvmCode.desc(LoopCode.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final ClassDesc DOUBLE = ConstantDescs.CD_double;
  private static final ClassDesc DOUBLES = DOUBLE.arrayType();
  private static final ClassDesc BYTES = ConstantDescs.CD_byte.arrayType();
  private static final MethodTypeDesc STORE =
      MethodTypeDesc.of(ConstantDescs.CD_void, DOUBLES, BYTES, INT, DOUBLE, INT);
  private static final MethodTypeDesc GIVES_INT = MethodTypeDesc.of(INT);

  private final CodeBuilder code;
  private final DirectForm form;
  private final DirectSlots slots;
  private final UnitGlobals globals;

  DirectRegisters(CodeBuilder code, DirectForm form, DirectSlots slots, UnitGlobals globals) {
    this.code = code;
    this.form = form;
    this.slots = slots;
    this.globals = globals;
  }

  /** Fetches the arrays of a function that has global variables; a loop is given them. */
  void begin() {
    if (form.loop().isEmpty() && globals.count() > 0) {
      fetch("numbers", DOUBLES, slots.registerNumbers);
      fetch("tags", BYTES, slots.registerTags);
      fetch("objects", JvmCode.VALUE.arrayType(), slots.registerObjects);
    }
  }

  private void fetch(String field, ClassDesc type, int variable) {
    code.aload(DirectSlots.THREAD).getfield(JvmCode.THREAD, field, type).astore(variable);
  }

  private void address(int slot) {
    int global = form.global(slot);
    if (global >= 0) {
      code.loadConstant(Instruction.index(globals.slot(global)));
    } else {
      code.iload(DirectSlots.BASE).loadConstant(slot).iadd();
    }
  }

  /** Loads a slot that has {@code tags}. */
  void load(int slot, int tags) {
    if (tags > TagSet.MAX) {
      loadElements(slot, tags);
      return;
    }
    DirectSlots.Kept kept = DirectSlots.Kept.of(tags);
    if (kept == DirectSlots.Kept.NOT) {
      return;
    }
    code.aload(slots.registerNumbers);
    address(slot);
    code.daload();
    if (kept == DirectSlots.Kept.LONG) {
      code.d2l().lstore(slots.longs[slot]);
      return;
    }
    code.dstore(slots.doubles[slot]);
    if (kept == DirectSlots.Kept.TAGGED) {
      code.aload(slots.registerTags);
      address(slot);
      code.baload().istore(slots.tagVariables[slot]);
    }
  }

  /** Takes over the elements of a list or matrix: nothing in direct code gives it others. */
  private void loadElements(int slot, int kind) {
    boolean list = (kind & TagSet.LIST) != 0;
    ClassDesc type = list ? JvmCode.LIST : JvmCode.MATRIX;
    code.aload(slots.registerObjects);
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

  /** Writes a slot back that has {@code tags}. */
  void store(int slot, int tags) {
    code.aload(slots.registerNumbers).aload(slots.registerTags);
    address(slot);
    slots.pushNumber(slot, tags);
    slots.pushSlotTag(slot, tags);
    code.invokestatic(LOOP_CODE, "store", STORE);
  }

  // --- global variables of functions, which are in the registers alone

  /** Loads the global variables that instruction {@code w} of a function looks at. */
  void loadGlobals(long w, int[] state) {
    if (form.loop().isPresent()) {
      return;
    }
    for (int operand : LoopInstructions.operandsInFunction(w)) {
      int slot = form.slot(operand);
      if (form.global(slot) >= 0) {
        load(slot, state[slot]);
      }
    }
  }

  /** Writes the global variable back that instruction {@code w} of a function has changed. */
  void storeGlobal(long w, int[] after) {
    if (form.loop().isPresent()) {
      return;
    }
    LoopInstructions.target(w)
        .ifPresent(
            operand -> {
              int slot = form.slot(operand);
              if (form.global(slot) >= 0) {
                store(slot, after[slot]);
              }
            });
  }

  // --- global variables of loops, around a call

  /** Writes those back that functions share. */
  void storeShared(int[] state) {
    if (form.loop().isEmpty()) {
      return;
    }
    for (int slot = form.function().slotCount(); slot < state.length; slot++) {
      if (globals.shared(form.global(slot))
          && TagSet.mayBeWritten(state[slot])
          && form.loop().get().writes(slot)) {
        store(slot, state[slot]);
      }
    }
  }

  /** Loads those again that functions change. */
  void loadShared(int[] after) {
    if (form.loop().isEmpty()) {
      return;
    }
    for (int slot = form.function().slotCount(); slot < after.length; slot++) {
      if (globals.writtenByFunctions(form.global(slot))) {
        load(slot, after[slot]);
      }
    }
  }

  /** What is left to be written back after {@link #storeShared}. */
  int[] withoutShared(int[] state) {
    int[] left = state.clone();
    for (int slot = form.function().slotCount(); slot < left.length; slot++) {
      if (globals.shared(form.global(slot))) {
        left[slot] = 0;
      }
    }
    return left;
  }
}
