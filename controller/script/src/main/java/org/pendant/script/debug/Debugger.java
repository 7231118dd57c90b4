package org.pendant.script.debug;

import static org.pendant.script.debug.DebuggerTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramProbe;
import org.pendant.script.vm.StackMark;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Debugger: pauses the primary program of one machine at breakpoints, after steps, on request and
 * before it fails. While it is paused no thread runs and no time passes, so the program does what
 * it would have done without.
 *
 * <p>Only the thread that drives the frames may call this, between two frames or at their start.
 * What cannot be done is refused with an {@link IllegalArgumentException}. Calls of functions are
 * named by their thread and their depth, 1 for the outermost; {@link #MAIN} and {@link #OUTERMOST}
 * name the one where all global variables can be seen.
 */
public final class Debugger {
  /** The main thread. */
  public static final int MAIN = 0;

  /** The depth of the call that a thread began with. */
  public static final int OUTERMOST = 1;

  private final ProgramProbe probe;
  private final Breakpoints breakpoints = new Breakpoints();
  private final Stops stops;
  private Consumer<DebugRequest> journal = request -> {};
  private boolean shared;

  /**
   * A debugger of what {@code machine} will run; there can be one at a time.
   *
   * @param log takes the messages of breakpoints that write one instead of stopping; the texts are
   *     bytes, one {@code char} a byte
   */
  public Debugger(Machine machine, Consumer<String> log) {
    probe = machine.probe();
    stops = new Stops(probe, breakpoints, log);
    machine.attach(stops);
  }

  /** Has {@code journal} told what is asked from now on, before it is carried out. */
  public void noteIn(Consumer<DebugRequest> journal) {
    this.journal = journal;
  }

  // --- breakpoints

  /** Sets a breakpoint, in place of the one on its line, and tells where it is. */
  public BreakpointState set(Breakpoint breakpoint) {
    journal.accept(new DebugRequest.SetBreakpoint(breakpoint));
    BreakpointState set = breakpoints.set(breakpoint);
    stops.setTraps();
    return set;
  }

  /** Removes the breakpoint that was set on {@code line}; whether there was one. */
  public boolean remove(int line) {
    journal.accept(new DebugRequest.RemoveBreakpoint(line));
    boolean removed = breakpoints.remove(line);
    stops.setTraps();
    return removed;
  }

  /** Removes every breakpoint. */
  public void removeBreakpoints() {
    journal.accept(new DebugRequest.RemoveBreakpoints());
    breakpoints.removeAll();
    stops.setTraps();
  }

  /** All breakpoints in the order of their lines. */
  public List<BreakpointState> breakpoints() {
    return breakpoints.states();
  }

  /** Whether a program that fails is paused before it ends; not so at first. */
  public void stopOnErrors(boolean wanted) {
    journal.accept(new DebugRequest.StopOnErrors(wanted));
    stops.onErrors(wanted);
  }

  /**
   * Whether several debug the program from now on, not so at first: each is to take only its own
   * breakpoints away then.
   */
  public void share(boolean wanted) {
    shared = wanted;
  }

  /** Whether several debug the program. */
  public boolean shared() {
    return shared;
  }

  /** Whether a program that fails is paused before it ends. */
  public boolean stopsOnErrors() {
    return stops.onErrors();
  }

  /**
   * Whether {@link #state} also has the threads while nothing is paused, so that who looks back at
   * a recording sees the calls of each frame; not so at first. Nothing happens in another way by
   * it.
   */
  public void followCalls(boolean wanted) {
    stops.followCalls(wanted);
  }

  // --- holding and continuing

  /** Holds the running program before anything of the next frame has run. */
  public void pause() {
    journal.accept(new DebugRequest.Pause());
    refuseHeld();
    probe.hold();
    if (!probe.held()) {
      throw new IllegalArgumentException(text("noneRunning"));
    }
    stops.stop(new PauseReason.PauseRequested(), MAIN);
  }

  /** Lets the program continue; one that has failed ends now. */
  public void resume() {
    journal.accept(new DebugRequest.Resume());
    refuseUnlessHeld();
    go(Optional.empty());
  }

  /** The step of a thread that stopped where it stands is over what it stands before. */
  private void standBefore(int thread) {
    if (stops.state().stop().orElseThrow().thread() == thread) {
      probe.standBefore(thread);
    }
  }

  /** Lets the program continue until {@code thread} comes to its next statement in any function. */
  public void stepInto(int thread) {
    journal.accept(new DebugRequest.StepInto(thread));
    refuseUnlessSteppable();
    standBefore(thread);
    probe.mark(thread);
    go(Optional.of(new StepRequest.Into(thread)));
  }

  /**
   * Lets the program continue until {@code thread} comes to its next statement in the function that
   * it is in, or in the caller if that returns.
   */
  public void stepOver(int thread) {
    journal.accept(new DebugRequest.StepOver(thread));
    refuseUnlessSteppable();
    standBefore(thread);
    go(Optional.of(new StepRequest.Over(thread, probe.mark(thread))));
  }

  /**
   * Lets the program continue until {@code thread} has left its function and comes to the next
   * statement of a caller.
   */
  public void stepOut(int thread) {
    journal.accept(new DebugRequest.StepOut(thread));
    refuseUnlessSteppable();
    standBefore(thread);
    go(Optional.of(new StepRequest.Out(thread, probe.mark(thread))));
  }

  /**
   * Lets the program continue until {@code thread} comes to the statement that a breakpoint on
   * {@code line} would mean.
   */
  public void runTo(int thread, int line) {
    journal.accept(new DebugRequest.RunTo(thread, line));
    refuseUnlessSteppable();
    probe.mark(thread);
    int start =
        program()
            .statementFrom(line)
            .orElseThrow(() -> new IllegalArgumentException(text("noStatementFrom", line)));
    go(Optional.of(new StepRequest.To(thread, start)));
  }

  /**
   * Lets the program continue until a thread, whichever, comes to a statement that calls one of
   * {@code functions} itself. Where {@code thread} stands before such a statement or within one,
   * its next statement in the function that it is in, or in a caller, ends the step as well.
   *
   * @param functions names of built-in functions
   */
  public void stepToCall(int thread, Set<String> functions) {
    journal.accept(new DebugRequest.StepToCall(thread, functions));
    refuseUnlessSteppable();
    standBefore(thread);
    Set<Integer> starts = program().statementsCalling(functions);
    OptionalInt at = probe.statementOf(thread);
    StackMark calls = probe.mark(thread);
    boolean within = at.isPresent() && starts.contains(at.getAsInt());
    go(
        Optional.of(
            new StepRequest.ToAny(thread, starts, within ? Optional.of(calls) : Optional.empty())));
  }

  private Program program() {
    return probe.program().orElseThrow(() -> new IllegalArgumentException(text("noneRunning")));
  }

  /** Ends a thread of a paused program, and those that it started. */
  public void kill(int thread) {
    journal.accept(new DebugRequest.Kill(thread));
    refuseUnlessSteppable();
    probe.kill(thread);
    stops.threadKilled();
  }

  private void go(Optional<StepRequest> step) {
    stops.go(step);
    probe.release();
  }

  private void refuseHeld() {
    if (probe.held()) {
      throw new IllegalArgumentException(text("pausedAlready"));
    }
  }

  private void refuseUnlessHeld() {
    if (!probe.held()) {
      throw new IllegalArgumentException(text("notPaused"));
    }
  }

  private void refuseUnlessSteppable() {
    refuseUnlessHeld();
    if (probe.failure().isPresent()) {
      throw new IllegalArgumentException(text("failed"));
    }
  }

  // --- looking

  /** Whether the program is paused, and where; the same object while nothing changes. */
  public DebugState state() {
    return stops.state();
  }

  /** Where the threads of the program are now, also while it is not paused. */
  public List<ThreadSnapshot> threads() {
    return probe.threads();
  }

  /**
   * Where those threads are that have computed for the last {@code frames} frames without waiting.
   */
  public List<ThreadSnapshot> busyThreads(int frames) {
    return probe.busyThreads(frames);
  }

  /** Parameters and local variables of a call. */
  public List<Variable> variables(int thread, int depth) {
    return Variables.of(probe.variables(thread, depth));
  }

  /** The global variables. */
  public List<Variable> globals() {
    return Variables.of(probe.globals());
  }

  /**
   * Elements or members of a value.
   *
   * @param expression what yields it in the call, see {@link Variable#expression}
   * @param from index of the first that is wanted
   * @param count how many are wanted, 1 to 1000
   * @throws ScriptError as for {@link #evaluate}
   */
  public List<Variable> children(int thread, int depth, String expression, int from, int count)
      throws ScriptError {
    return Variables.children(expression, value(thread, depth, expression), from, count);
  }

  /**
   * The value of an expression in the scope of a call. Variables stay as they are whatever it does.
   *
   * @throws ScriptError when it is no expression, fails, or would take robot time
   */
  public Variable evaluate(int thread, int depth, String expression) throws ScriptError {
    return Variables.of(expression, expression, value(thread, depth, expression));
  }

  private Value value(int thread, int depth, String expression) throws ScriptError {
    if (expression.indexOf('(') >= 0) {
      // it may call something
      journal.accept(new DebugRequest.Evaluate(thread, depth, expression));
    }
    return probe.evaluate(thread, depth, expression);
  }

  /**
   * Changes a variable, or an element or member of one, by the rules of an assignment in the call.
   * A program that is not paused continues with the new value: to it, nothing happens between two
   * frames.
   *
   * @param expression a literal or any other expression
   * @return what it is now
   * @throws ScriptError when the rules refuse it, or as for {@link #evaluate}; nothing has changed
   */
  public Variable assign(int thread, int depth, String target, String expression)
      throws ScriptError {
    journal.accept(new DebugRequest.Assign(thread, depth, target, expression));
    probe.assign(thread, depth, target, expression);
    return Variables.of(target, target, probe.evaluate(thread, depth, target));
  }
}
