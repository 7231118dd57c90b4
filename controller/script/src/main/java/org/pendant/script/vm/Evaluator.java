package org.pendant.script.vm;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Host;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Processor.Stop;

/**
 * Evaluator: computes expressions and assignments as a call of a running program would, beside the
 * program: on copies of all variables, in a thread of its own. So a failure leaves no trace, and
 * even what succeeds changes nothing but the one variable that is assigned. Built-in functions do
 * what they always do; those that take robot time are refused before anything has run.
 */
final class Evaluator {
  /** Compiled expressions that are kept: conditions of breakpoints are computed again and again. */
  private static final int MAX_KEPT = 64;

  /** Computing time of one of them, in nanoseconds as {@link Cost} counts them. */
  private static final int MAX_NS = 1_000_000;

  /** An expression at a place. */
  private record Place(ScriptFunction function, int offset, String text) {}

  private final Host host;
  private final SideCompiler compiler;
  private final Map<Place, SideCode> kept = new LinkedHashMap<>();
  private ProgramRun compiledFor;
  private int links;

  Evaluator(Builtins<?> builtins, Host host, Interpreter interpreter) {
    this.host = host;
    this.compiler = new SideCompiler(builtins, interpreter);
  }

  /**
   * The value of an expression.
   *
   * @param frame index of the call in {@code thread}, 0 for the outermost
   * @return a value that no other code uses
   */
  Value value(ProgramRun run, ScriptThread thread, int frame, String text) throws ScriptError {
    SideCode code = compiled(run, place(thread, frame, text));
    return run(run, thread, frame, code);
  }

  /**
   * Assigns to a variable or a part of one, by the rules of an assignment in the program.
   *
   * @param frame as in {@link #value}
   */
  void assign(ProgramRun run, ScriptThread thread, int frame, String target, String value)
      throws ScriptError {
    Place place = place(thread, frame, target);
    SideCode code = compiler.assignment(run, place.function(), place.offset(), target, value);
    Value assigned = run(run, thread, frame, code);
    run.registers().set(code.resultSlot(thread.bases[frame]), assigned);
  }

  private static Place place(ScriptThread thread, int frame, String text) {
    ScriptFunction function = thread.functions[frame].original();
    return new Place(function, function.range(thread.reached(frame)).start(), text);
  }

  private SideCode compiled(ProgramRun run, Place place) throws ScriptError {
    if (compiledFor != run || links != run.links()) {
      compiledFor = run;
      links = run.links();
      kept.clear();
    }
    SideCode code = kept.get(place);
    if (code == null) {
      code = compiler.expression(run, place.function(), place.offset(), place.text());
      if (kept.size() == MAX_KEPT) {
        Iterator<Place> oldest = kept.keySet().iterator();
        oldest.next();
        oldest.remove();
      }
      kept.put(place, code);
    }
    return code;
  }

  private Value run(ProgramRun run, ScriptThread thread, int frame, SideCode code)
      throws ScriptError {
    ProgramRun side = run.onTheSide(code.tables(), host, new SideControl(run.frame()));
    Registers registers = side.registers();
    StaticSlots statics = code.statics();
    registers.grow(statics.first() + statics.names().size());
    side.fill(statics, 0);
    if (code.changing()) {
      copyObjects(registers, run.globalSlots().values());
    }
    ScriptThread worker = worker(side, thread, frame, code);
    refuseUnlessEnded(side.processor().execute(worker), worker);
    return registers.value(code.resultSlot(worker.segmentStart));
  }

  /** A thread that is about to run {@code code} with the variables of a call. */
  private static ScriptThread worker(
      ProgramRun side, ScriptThread thread, int frame, SideCode code) {
    ScriptFunction function = code.function();
    ScriptThread worker = new ScriptThread(0, -1, side.marks());
    worker.budget = MAX_NS;
    worker.segmentStart = side.segments().take(function.slotCount());
    worker.segmentEnd = worker.segmentStart + RegisterSegments.sizeFor(function.slotCount());
    Registers registers = side.registers();
    int from = thread.bases[frame];
    for (int i = 0; i < function.variableCount(); i++) {
      int to = worker.segmentStart + i;
      registers.tags()[to] = registers.tags()[from + i];
      registers.numbers()[to] = registers.numbers()[from + i];
      registers.objects()[to] = registers.objects()[from + i];
    }
    if (code.changing()) {
      copyObjects(registers, slots(worker.segmentStart, function.variableCount()));
    }
    worker.push(function, worker.segmentStart, 0);
    return worker;
  }

  private static List<Integer> slots(int first, int count) {
    return IntStream.range(first, first + count).boxed().toList();
  }

  private static void copyObjects(Registers registers, Iterable<Integer> slots) {
    for (int slot : slots) {
      if (registers.tags()[slot] == Registers.OBJECT) {
        registers.objects()[slot] = registers.objects()[slot].copy();
      }
    }
  }

  private static void refuseUnlessEnded(Stop stop, ScriptThread worker) throws ScriptError {
    switch (stop) {
      case ENDED -> {}
      case EXHAUSTED ->
          throw new ScriptError(
              "too-long", MachineTexts.text("computesTooLong", MAX_NS / 1_000_000));
      case WAITING -> {
        worker.wait.cancel();
        throw new ScriptError("not-while-stopped", MachineTexts.text("waits"));
      }
      default -> throw new ScriptError("not-while-stopped", MachineTexts.text("wouldStop"));
    }
  }
}
