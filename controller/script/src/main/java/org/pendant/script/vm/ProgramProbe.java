package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Program probe: what a debugger may see of the running primary program and do to it. Frame loop
 * only; threads are named by their handles and calls by their depth, 1 for the outermost.
 *
 * <p>A thread or call that is not there is refused with an {@link IllegalArgumentException}.
 */
public final class ProgramProbe {
  private final Machine machine;
  private final Evaluator evaluator;
  private final FollowedCalls followed = new FollowedCalls();

  ProgramProbe(Machine machine, Evaluator evaluator) {
    this.machine = machine;
    this.evaluator = evaluator;
  }

  // --- holding

  /** Whether scripts and time are paused. */
  public boolean held() {
    return machine.held();
  }

  /** Holds a running program between two frames. */
  public void hold() {
    machine.hold();
  }

  /** Continues; a program that has failed ends instead. */
  public void release() {
    machine.release();
  }

  /** The failure that will end the program that is paused. */
  public Optional<ScriptFailure> failure() {
    return machine.failure();
  }

  /** The program that runs or is paused. */
  public Optional<Program> program() {
    return machine.run().map(ProgramRun::program);
  }

  // --- traps

  /** Sets traps before some statements of the text, given by their first offsets, and no others. */
  public void trap(Set<Integer> starts) {
    set(new BreakpointPatches.Plan(starts, Set.of(), false, false));
  }

  /** As {@link #trap}, and before all statements of the functions that {@code thread} is in. */
  public void trapCalls(Set<Integer> starts, int thread) {
    ScriptThread found = thread(thread);
    Set<ScriptFunction> whole = new HashSet<>();
    for (int i = 0; i < found.depth; i++) {
      whole.add(found.functions[i].original());
    }
    set(new BreakpointPatches.Plan(starts, whole, false, true));
  }

  /** Sets traps before all statements. */
  public void trapEverything() {
    set(new BreakpointPatches.Plan(Set.of(), Set.of(), true, true));
  }

  private void set(BreakpointPatches.Plan plan) {
    machine.run().ifPresent(run -> run.trap(plan));
  }

  /**
   * The first offset of the statement before which {@code thread} stands at a trap; empty when that
   * is not in the program's text.
   */
  public OptionalInt statementStart(int thread) {
    ScriptThread found = thread(thread);
    ScriptFunction function = found.functions[found.depth - 1];
    int number = function.statements().beginningAt(found.pcs[found.depth - 1]);
    return number >= 0 && isProgramText(function)
        ? OptionalInt.of(function.statements().start(number))
        : OptionalInt.empty();
  }

  /**
   * The first offset of the statement that {@code thread} stands before or is within; empty when
   * that is not in the program's text.
   */
  public OptionalInt statementOf(int thread) {
    ScriptThread found = thread(thread);
    int top = found.depth - 1;
    ScriptFunction function = found.functions[top];
    int number = function.statements().around(found.reached(top));
    return number >= 0 && isProgramText(function)
        ? OptionalInt.of(function.statements().start(number))
        : OptionalInt.empty();
  }

  private boolean isProgramText(ScriptFunction function) {
    return function.source().equals(run().program().source());
  }

  // --- threads

  /** All threads that have not ended, the main thread first. */
  public List<ThreadSnapshot> threads() {
    List<ThreadSnapshot> snapshots = new ArrayList<>();
    machine
        .run()
        .ifPresent(run -> run.threads().forEach(thread -> snapshots.add(snapshot(run, thread))));
    return snapshots;
  }

  /**
   * As {@link #threads}, and the same object as the last time while no thread has come elsewhere;
   * empty while there are very many calls.
   */
  public List<ThreadSnapshot> followedThreads() {
    return machine.run().map(run -> followed.of(run, this)).orElse(List.of());
  }

  /** Those threads that have not waited for anything in the last {@code frames} frames. */
  public List<ThreadSnapshot> busyThreads(int frames) {
    List<ThreadSnapshot> busy = new ArrayList<>();
    machine
        .run()
        .ifPresent(
            run ->
                run.threads().stream()
                    .filter(thread -> thread.busyFrames >= frames)
                    .forEach(thread -> busy.add(snapshot(run, thread))));
    return busy;
  }

  /** One thread. */
  public ThreadSnapshot snapshot(int thread) {
    return snapshot(run(), thread(thread));
  }

  private static ThreadSnapshot snapshot(ProgramRun run, ScriptThread thread) {
    List<ThreadSnapshot.Level> stack = new ArrayList<>();
    for (int i = thread.depth - 1; i >= 0; i--) {
      stack.add(level(thread, i, thread.reached(i)));
    }
    return new ThreadSnapshot(
        thread.id(), thread.functions[0].name(), waitsFor(run, thread), stack);
  }

  private static ThreadSnapshot.Level level(ScriptThread thread, int index, int pc) {
    ScriptFunction function = thread.functions[index];
    StatementTable statements = function.statements();
    int statement = statements.beginningAt(pc);
    boolean next = thread.trapped && index == thread.depth - 1 && statement >= 0;
    return new ThreadSnapshot.Level(
        function.name(),
        function.source().name(),
        next ? function.source().line(statements.start(statement)) : function.line(pc),
        next ? statements.range(statement) : function.range(pc));
  }

  private static String waitsFor(ProgramRun run, ScriptThread thread) {
    return switch (thread.state) {
      case RUNNABLE, ENDED -> "";
      case JOINING -> text("threadNumber", thread.joined.orElseThrow().id());
      case WAITING -> {
        int top = thread.depth - 1;
        long word = thread.functions[top].instructions()[thread.reached(top)];
        yield Instruction.operation(word) == Op.CALL_BUILTIN
            ? run.builtin(Instruction.b(word)).name()
            : text("aMethod");
      }
    };
  }

  /** How many calls {@code thread} is in. */
  public int depth(int thread) {
    return thread(thread).depth;
  }

  /**
   * A thread that stands before a statement of its own accord, at the start of a program say,
   * counts as stopped there: its next step is over that statement, not to it.
   */
  public void standBefore(int thread) {
    ScriptThread found = thread(thread);
    if (found.state == ScriptThread.State.RUNNABLE && statementStart(thread).isPresent()) {
      found.trapped = true;
    }
  }

  /** Which calls {@code thread} is in. */
  public StackMark mark(int thread) {
    return StackMark.of(thread(thread));
  }

  /**
   * The depth of the innermost call of {@code thread} if it was there when {@code mark} was made; 0
   * for a newer one.
   */
  public int depthSince(StackMark mark, int thread) {
    return mark.depthOf(thread(thread));
  }

  /** Ends {@code thread} and those it started; the main thread only ends with the program. */
  public void kill(int thread) {
    ScriptThread found = thread(thread);
    if (found == run().main()) {
      throw new IllegalArgumentException(text("mainThreadStays"));
    }
    run().killTree(found);
  }

  // --- variables

  /** The variables of one call: parameters, then others, in the order of their assignments. */
  public List<NamedValue> variables(int thread, int depth) {
    ScriptThread found = thread(thread);
    int index = index(found, depth);
    List<String> names = found.functions[index].variables();
    List<NamedValue> variables = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      if (!names.get(i).isEmpty()) {
        variables.add(named(names.get(i), found.bases[index] + i));
      }
    }
    return variables;
  }

  /** The global variables, in the order in which the text mentions them. */
  public List<NamedValue> globals() {
    List<NamedValue> variables = new ArrayList<>();
    List<String> names = run().program().tables().staticNames();
    for (int slot = 0; slot < names.size(); slot++) {
      if (!names.get(slot).isEmpty()) {
        variables.add(named(names.get(slot), slot));
      }
    }
    return variables;
  }

  private NamedValue named(String name, int slot) {
    Registers registers = run().registers();
    return new NamedValue(
        name, registers.assigned(slot) ? Optional.of(registers.value(slot)) : Optional.empty());
  }

  /**
   * The value of an expression in the scope of a call. It is computed on copies, so the program
   * continues as if nothing had happened, whether it succeeds or fails; only built-in functions
   * have the effects that they always have.
   *
   * @throws ScriptError when it is no expression, fails, or would take robot time
   */
  public Value evaluate(int thread, int depth, String expression) throws ScriptError {
    ScriptThread found = thread(thread);
    return evaluator.value(run(), found, index(found, depth), expression);
  }

  /**
   * Assigns the value of an expression to a variable, an element or a member, by the rules of an
   * assignment that stands in the call.
   *
   * @throws ScriptError when the rules refuse it, or as for {@link #evaluate}; nothing has changed
   */
  public void assign(int thread, int depth, String target, String expression) throws ScriptError {
    ScriptThread found = thread(thread);
    evaluator.assign(run(), found, index(found, depth), target, expression);
  }

  private static int index(ScriptThread thread, int depth) {
    if (depth < 1 || depth > thread.depth) {
      throw new IllegalArgumentException(
          "call is " + depth + ", must be 1 to " + thread.depth + " in thread " + thread.id());
    }
    return depth - 1;
  }

  private ProgramRun run() {
    return machine.run().orElseThrow(() -> new IllegalArgumentException(text("noneRunning")));
  }

  private ScriptThread thread(int id) {
    return run()
        .thread(id)
        .filter(thread -> thread.depth > 0)
        .orElseThrow(() -> new IllegalArgumentException(text("noThread", id)));
  }
}
