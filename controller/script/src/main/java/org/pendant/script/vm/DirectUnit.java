package org.pendant.script.vm;

import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeBuilder;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Direct unit: a function and those it calls, for arguments of known tags, that become methods of
 * one {@link DirectCode} and call each other as such; or a loop and those it calls, which become a
 * {@link LoopCode}.
 */
final class DirectUnit {
  /** The JVM does not compile methods of more bytes than this. */
  private static final int LARGEST = 8000;

  static final int MAX_FORMS = 16;
  private static final int MAX_INSTRUCTIONS = 300;
  private static final int MAX_SLOTS = 40;
  private static final int MAX_LOOP_SLOTS = 120;

  /** Each adds a tag to a result, of which there are few, so there are never as many. */
  private static final int MAX_ROUNDS = MAX_FORMS * TagSet.BITS;

  private static final ClassDesc DIRECT_CODE = JvmCode.desc(DirectCode.class);
  private static final ClassDesc LOOP_CODE = JvmCode.desc(LoopCode.class);

  /** The type of {@link LoopCode#run}. */
  static final MethodTypeDesc LOOP =
      MethodTypeDesc.of(
          ConstantDescs.CD_void,
          JvmCode.THREAD,
          ConstantDescs.CD_int,
          ConstantDescs.CD_double.arrayType(),
          ConstantDescs.CD_byte.arrayType(),
          JvmCode.VALUE.arrayType(),
          ConstantDescs.CD_int);

  static final ClassDesc SELF = ClassDesc.of(DirectCode.class.getPackageName(), "DirectFunctions");

  private final Program.Tables tables;
  private final UnitGlobals globals;
  private final List<DirectForm> forms = new ArrayList<>();

  private DirectUnit(Program.Tables tables, UnitGlobals globals) {
    this.tables = tables;
    this.globals = globals;
  }

  /** The global variables of its functions and loop. */
  UnitGlobals globals() {
    return globals;
  }

  /**
   * Makes code for calls of function {@code number} with arguments that {@code key} tells of, and
   * gives it to the function unless it would never come to its end.
   *
   * @param before what global variables are when it is entered
   * @return whether there is such code
   */
  static boolean translate(Program.Tables tables, int number, long key, GlobalTags before) {
    Set<Integer> named = GlobalTags.named(tables, List.of(number));
    DirectUnit unit = new DirectUnit(tables, new UnitGlobals(before, named));
    ScriptFunction function = tables.functions().get(number);
    DirectForm root = unit.form(number, DirectEntry.tags(key, function.parameterCount()));
    if (root == null || !unit.flow() || root.result() == 0) {
      return false;
    }
    byte[] bytes =
        unit.write(
            DIRECT_CODE,
            "call",
            DirectEntryMethod.CALL,
            code -> DirectEntryMethod.write(code, root, unit));
    if (HiddenClass.largestMethod(bytes) > LARGEST) {
      return false;
    }
    function.installDirect(
        key, before, HiddenClass.make(bytes, DirectCode.class), unit.mostSlots());
    return true;
  }

  /**
   * Makes code for a loop with the variables that {@code entry} is for, and gives it to the entry
   * unless it cannot go round.
   */
  static void translate(Program.Tables tables, LoopEntry entry) {
    LoopRegion loop = entry.region();
    LiveTemporaries live = new LiveTemporaries(tables);
    if (loop.isTooLong()
        || loop.slotCount() > MAX_LOOP_SLOTS
        || live.hasTemporaries(loop.function(), loop.head())) {
      return;
    }
    UnitGlobals globals = new UnitGlobals(loop.globals(entry.tags()), loop.shared());
    DirectUnit unit = new DirectUnit(tables, globals);
    DirectForm root = new DirectForm(unit, tables, loop, entry.tags());
    unit.forms.add(root);
    if (!unit.flow()) {
      return;
    }
    byte[] bytes = unit.write(LOOP_CODE, "run", LOOP, code -> unit.enterLoop(code, root));
    if (HiddenClass.largestMethod(bytes) <= LARGEST) {
      entry.install(HiddenClass.make(bytes, LoopCode.class), unit.mostSlots());
    }
  }

  private void enterLoop(CodeBuilder code, DirectForm root) {
    code.aload(1).iload(2).aload(3).aload(4).aload(5).iload(6);
    code.invokestatic(SELF, method(root), LOOP).return_();
  }

  private int mostSlots() {
    return forms.stream().mapToInt(form -> form.function().slotCount()).max().orElseThrow();
  }

  /** The form for arguments of these tags; null when there is none. */
  DirectForm form(int number, int[] parameters) {
    for (DirectForm form : forms) {
      if (form.is(number, parameters)) {
        return form;
      }
    }
    ScriptFunction function = tables.functions().get(number);
    if (forms.size() == MAX_FORMS
        || function.instructions().length > MAX_INSTRUCTIONS
        || function.slotCount() > MAX_SLOTS) {
      return null;
    }
    DirectForm form = new DirectForm(this, tables, number, parameters);
    forms.add(form);
    return form;
  }

  /** The method of {@code form}. */
  String method(DirectForm form) {
    return "f" + forms.indexOf(form);
  }

  private boolean flow() {
    int most = MAX_ROUNDS + globals.count() * (TagSet.BITS + 1);
    boolean changed = true;
    for (int round = 0; changed && round < most; round++) {
      changed = false;
      for (int i = 0; i < forms.size(); i++) {
        changed |= forms.get(i).flow();
      }
      changed |= globals.takeChanged();
    }
    return !changed;
  }

  /** A class of that type, with the method that is entered and one for each form. */
  private byte[] write(
      ClassDesc superclass, String name, MethodTypeDesc entry, Consumer<CodeBuilder> body) {
    return ClassFile.of()
        .build(
            SELF,
            type -> {
              type.withSuperclass(superclass)
                  .withFlags(ClassFile.ACC_FINAL | ClassFile.ACC_SUPER)
                  .withMethodBody(
                      ConstantDescs.INIT_NAME,
                      ConstantDescs.MTD_void,
                      0,
                      code ->
                          code.aload(0)
                              .invokespecial(
                                  superclass, ConstantDescs.INIT_NAME, ConstantDescs.MTD_void)
                              .return_())
                  .withMethodBody(name, entry, 0, body);
              for (int i = 0; i < forms.size(); i++) {
                DirectForm form = forms.get(i);
                type.withMethodBody(
                    method(form),
                    DirectSlots.type(form),
                    ClassFile.ACC_STATIC,
                    code -> new DirectMethod(code, form, this).write());
              }
            });
  }
}
