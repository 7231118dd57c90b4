package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.BitSet;
import org.pendant.script.function.Builtin;
import org.pendant.script.value.ScriptError;

/**
 * Side effect search: looks through the code of an expression, and of all functions that it may
 * come to call.
 */
final class SideEffects {
  private final Program.Tables tables;
  private final BitSet seen = new BitSet();
  private boolean changing;

  private SideEffects(Program.Tables tables) {
    this.tables = tables;
  }

  /**
   * Whether {@code expression} may change the content of a list, matrix or struct.
   *
   * @throws ScriptError when it may take robot time, or start, end or stop threads
   */
  static boolean changes(ScriptFunction expression, Program.Tables tables) throws ScriptError {
    SideEffects effects = new SideEffects(tables);
    effects.look(expression);
    return effects.changing;
  }

  private void look(ScriptFunction function) throws ScriptError {
    for (long w : function.instructions()) {
      int b = Instruction.b(w);
      switch (Instruction.operation(w)) {
        case Op.CALL_BUILTIN -> {
          Builtin<?> builtin = tables.builtins().get(b);
          if (builtin.signature().physicalTime()) {
            throw refused(text("takesTime", builtin.name()));
          }
        }
        case Op.CALL_METHOD, Op.CALL_PART_METHOD -> changing = true;
        case Op.CALL -> {
          changing = true;
          if (!seen.get(b)) {
            seen.set(b);
            look(tables.functions().get(b).original());
          }
        }
        case Op.RUN -> throw refused(text("runStarts"));
        case Op.JOIN -> throw refused(text("joinWaits"));
        case Op.KILL -> throw refused(text("killEnds"));
        case Op.HALT -> throw refused(text("haltEnds"));
        case Op.PAUSE -> throw refused(text("pauseStops"));
        default -> {}
      }
    }
  }

  private static ScriptError refused(String what) {
    return new ScriptError("not-while-stopped", text("leavesThreadsAlone", what));
  }
}
