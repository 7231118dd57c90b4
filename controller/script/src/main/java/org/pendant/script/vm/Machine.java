package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Foreseen;
import org.pendant.script.function.Host;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.ProgramControl;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Virtual machine: runs one primary program at a time, and secondary programs beside it. Not
 * thread-safe: the frame loop owns it.
 */
public final class Machine {
  private final Builtins<?> builtins;
  private final Host host;
  private final LookAhead lookAhead;
  private final Translation translation;
  private final long memoryBytes;
  private final Interpreter interpreter;
  private final Companion companion;
  private Optional<ProgramRun> run = Optional.empty();
  private Optional<VariableSlots> variableSlots = Optional.empty();
  private ProgramState state = ProgramState.STOPPED;

  /** A pause has been asked for, and the motion needs to know where it leads on before. */
  private boolean pausing;

  /** The program has run past its last statement, and its last move continues to its waypoint. */
  private boolean arriving;

  private Optional<Ending> ending = Optional.empty();
  private String programName = "";
  private DebugHook debugHook = DebugHook.NONE;
  private boolean held;

  /** A fault of ours that the program continued after is in the log. */
  private boolean faultTold;

  private Optional<ScriptFailure> failure = Optional.empty();
  private Optional<ScriptPlace> failurePlace = Optional.empty();
  private Optional<ProgramRun> underWayBeside = Optional.empty();
  private List<ProgramEvent> events = new ArrayList<>();

  /**
   * @param builtins what programs may call
   * @param host what programs run on; the one that {@code builtins} are for
   * @param memoryBytes what the values of one program may take together, see {@link
   *     Value#sizeBytes}
   */
  public <H extends Host> Machine(Builtins<H> builtins, H host, long memoryBytes) {
    this(builtins, host, memoryBytes, Translation.WHEN_HOT);
  }

  /** A machine with another way to choose what is translated, for tests. */
  <H extends Host> Machine(
      Builtins<H> builtins, H host, long memoryBytes, Translation translation) {
    this.builtins = builtins;
    this.host = host;
    this.memoryBytes = memoryBytes;
    lookAhead = new LookAhead(host);
    this.translation = translation;
    this.interpreter = new Interpreter(builtins, host::warn);
    companion = new Companion(builtins, host, translation, memoryBytes);
    host.placeMessagesBy(this::place);
  }

  /**
   * Starts a primary program; it runs from the next {@link #advance} on.
   *
   * @throws IllegalStateException while another one runs or is paused
   */
  public void start(Program program) {
    if (state != ProgramState.STOPPED) {
      throw new IllegalStateException("program " + programName + " is " + state);
    }
    ProgramRun started =
        new ProgramRun(
            program,
            builtins,
            host,
            new Control(),
            interpreter::next,
            translation,
            debugHook,
            new RunLimits(Slices.PRIMARY, memoryBytes));
    run = Optional.of(started);
    variableSlots = Optional.of(new VariableSlots(started));
    interpreter.programStarted(started);
    programName = program.name();
    ending = Optional.empty();
    pausing = false;
    arriving = false;
    faultTold = false;
    state = ProgramState.RUNNING;
    events.add(new ProgramEvent.Started(programName, program.labels()));
    debugHook.programStarted();
  }

  /**
   * Runs a secondary program to its end, within the frame (manual 12).
   *
   * @return why it failed, empty when it did not; the primary program continues in any case
   */
  public Optional<ScriptFailure> runSecondary(Program program) {
    Optional<ScriptFailure> why = runBeside(program);
    why.ifPresent(each -> events.add(new ProgramEvent.SecondaryFailed(program.name(), each)));
    return why;
  }

  private Optional<ScriptFailure> runBeside(Program program) {
    ProgramRun secondary =
        new ProgramRun(
            program,
            builtins,
            host,
            new SecondaryControl(),
            thread -> false,
            translation,
            DebugHook.NONE,
            new RunLimits(Slices.SECONDARY, memoryBytes));
    underWayBeside = Optional.of(secondary);
    try {
      if (secondary.advance() == Scheduler.FrameResult.RUNNING) {
        ScriptThread main = secondary.main();
        return Optional.of(
            ProgramFailure.of(
                main, new ScriptError("runtime-too-much-behind", text("secondaryTooLong"))));
      }
      return Optional.empty();
    } catch (ThreadFailure thrown) {
      return Optional.of(ProgramFailure.of(thrown.thread(), thrown.error()));
    } finally {
      underWayBeside = Optional.empty();
      secondary.endAll();
    }
  }

  /**
   * Runs all script threads for one frame; nothing while stopped or paused.
   *
   * @return whether a debugger has paused the program: the frame is not over then, time must not
   *     pass, and the next call continues with this frame
   */
  public boolean advance() {
    if (held || state != ProgramState.RUNNING) {
      return held;
    }
    ProgramRun running = run.orElseThrow();
    if (arriving) {
      if (!host.arriving()) {
        end(new Ending.Finished());
      }
      pauseWhenPossible();
      return false;
    }
    try {
      if (!running.heldInFrame()) {
        interpreter.feed(running.main());
      }
      switch (running.advance()) {
        case RUNNING -> {}
        case HELD -> held = true;
        case PAUSED -> pause();
        case HALTED -> end(new Ending.Halted());
        case FINISHED -> finish(running);
      }
    } catch (ThreadFailure thrown) {
      fail(thrown.thread(), ProgramFailure.of(thrown.thread(), thrown.error()));
    }
    Optional<Throwable> fault = running.takeFault();
    if (fault.isPresent()) {
      tellOnce("faultInTranslation", fault.get());
    }
    if (!held && state == ProgramState.RUNNING) {
      lookAhead(running);
      pauseWhenPossible();
    }
    return held;
  }

  /** A blend radius means nothing after the last move: the arm still goes to its waypoint. */
  private void finish(ProgramRun running) {
    running.endAll();
    arriving = host.arriving();
    if (!arriving) {
      end(new Ending.Finished());
    }
  }

  private void fail(ScriptThread thread, ScriptFailure why) {
    failurePlace = Optional.of(run.orElseThrow().placeOf(thread));
    if (debugHook.stopsAtFailure(thread.id(), why)) {
      failure = Optional.of(why);
      held = true;
    } else {
      end(new Ending.Failed(why));
    }
  }

  private void end(Ending how) {
    held = false;
    failure = Optional.empty();
    run.orElseThrow().endAll();
    interpreter.programEnded();
    host.programEnded();
    state = ProgramState.STOPPED;
    pausing = false;
    arriving = false;
    ending = Optional.of(how);
    events.add(new ProgramEvent.Ended(programName, how));
    debugHook.programEnded();
  }

  /** Ends the program and drops its values, where there is no room for anything else. */
  public void abandon() {
    stop();
    run = Optional.empty();
    variableSlots = Optional.empty();
  }

  /** The text of the running or last program. */
  public Optional<Source> source() {
    return run.map(each -> each.program().source());
  }

  /** What happened to programs since the last call, in order. */
  public List<ProgramEvent> takeEvents() {
    if (events.isEmpty()) {
      return List.of();
    }
    List<ProgramEvent> taken = List.copyOf(events);
    events = new ArrayList<>();
    return taken;
  }

  /** Whether a debugger has paused the program: neither scripts nor time continue. */
  public boolean held() {
    return held;
  }

  /** Has {@code debugHook} asked from the next program on; it takes the place of any before. */
  public void attach(DebugHook debugHook) {
    this.debugHook = debugHook;
  }

  /** What a debugger may see of the primary program and do to it. */
  public ProgramProbe probe() {
    return new ProgramProbe(this, new Evaluator(builtins, host, interpreter));
  }

  /** Holds a running program between two frames. */
  void hold() {
    held |= state == ProgramState.RUNNING;
  }

  /** Continues after a hold; a program that has failed ends. */
  void release() {
    held = false;
    failure.ifPresent(why -> end(new Ending.Failed(why)));
  }

  /** The program that runs or is paused. */
  Optional<ProgramRun> run() {
    return state == ProgramState.STOPPED ? Optional.empty() : run;
  }

  /** Why the program that is paused will end. */
  Optional<ScriptFailure> failure() {
    return failure;
  }

  /**
   * Stops script time where it stands, and the motion. When the arm only comes to rest after the
   * point where its move is handed over, threads continue until the next move is known: the path
   * would be another one if that were said too late.
   */
  public void pause() {
    if (state == ProgramState.RUNNING) {
      host.pauseMotion();
      pausing = true;
      pauseWhenPossible();
    }
  }

  /** Whether threads only run on until the arm's path to rest is known. */
  public boolean pausing() {
    return pausing;
  }

  private void pauseWhenPossible() {
    if (state == ProgramState.RUNNING && pausing && !host.handsOverBeforeRest()) {
      pausing = false;
      state = ProgramState.PAUSED;
    }
  }

  /** A move that has just begun and will blend is told which move comes next. */
  private void lookAhead(ProgramRun running) {
    if (!host.wantsLookAhead()) {
      return;
    }
    for (ScriptThread thread : running.threads()) {
      if (thread.state == ScriptThread.State.WAITING && thread.wait.wantsLookAhead()) {
        thread.wait.lookAhead(ahead(running, thread));
      }
    }
  }

  /** The moves that are known to come; none when looking for them fails, which does no harm. */
  private List<Foreseen> ahead(ProgramRun running, ScriptThread thread) {
    try {
      return lookAhead.after(running, thread, interpreter);
    } catch (RuntimeException | StackOverflowError e) {
      tellOnce("faultInLookAhead", e);
      return List.of();
    }
  }

  /** Logs our own mistake, once a program: what failed only makes it faster or smoother. */
  private void tellOnce(String key, Throwable fault) {
    if (!faultTold) {
      faultTold = true;
      host.warn(text(key));
      host.internalError(fault);
    }
  }

  public void resume() {
    if (pausing) {
      pausing = false;
      host.resumeMotion();
    } else if (state == ProgramState.PAUSED) {
      state = ProgramState.RUNNING;
    }
  }

  /** Ends the program from outside; no effect when none runs. */
  public void stop() {
    if (state != ProgramState.STOPPED) {
      end(new Ending.Stopped());
    }
  }

  /** Whether the program would end at once if it continued: its last statement is done. */
  public boolean nothingLeft() {
    return state != ProgramState.STOPPED && run.orElseThrow().main().nothingLeft();
  }

  public ProgramState state() {
    return state;
  }

  /** The 1-based line that the main thread has reached, 0 when no program runs. */
  public int line() {
    return state == ProgramState.STOPPED || run.isEmpty() ? 0 : run.get().main().line();
  }

  /** How the last primary program ended; empty while one runs and before the first. */
  public Optional<Ending> ending() {
    return ending;
  }

  /** What the script that runs just now is at; between turns the main thread of the program. */
  private Optional<ScriptPlace> place() {
    return companion.place().or(() -> underWayBeside.or(this::run).map(ProgramRun::place));
  }

  /** Where the last program that failed did so. */
  public Optional<ScriptPlace> failurePlace() {
    return failurePlace;
  }

  /** The name of the running or last program, empty before the first. */
  public String programName() {
    return programName;
  }

  /** Copies of the global variables of the running or last program, by name. */
  public SortedMap<String, Value> globals() {
    return run.map(ProgramRun::globals).orElse(Collections.emptySortedMap());
  }

  /**
   * What the running or last program has reached so far; empty before the first and for one that
   * was loaded without coverage.
   */
  public Optional<Coverage> coverage() {
    return run.flatMap(ProgramRun::coverage);
  }

  /**
   * Where the variables of the running or last program are kept; another object for each start of a
   * program, empty before the first.
   */
  public Optional<VariableSlots> variableSlots() {
    return variableSlots;
  }

  /** Whether a thread waits for something outside. */
  public boolean waitsForOutside() {
    if (state != ProgramState.RUNNING) {
      return false;
    }
    List<ScriptThread> threads = run.orElseThrow().threads();
    for (int i = 0; i < threads.size(); i++) {
      ScriptThread thread = threads.get(i);
      if (thread.state == ScriptThread.State.WAITING && thread.wait.outside()) {
        return true;
      }
    }
    return false;
  }

  /** Ends the running movej or movel of the main thread early (manual 13.5); false if none. */
  public boolean abortMove() {
    return state == ProgramState.RUNNING && run.orElseThrow().main().abortWait();
  }

  /** What runs beside the primary program, frame by frame. */
  public Companion companion() {
    return companion;
  }

  /** Interpreter mode (manual 13). */
  public Interpreter interpreter() {
    return interpreter;
  }

  /** What built-ins may do to the primary program. */
  private final class Control implements ProgramControl {
    @Override
    public long frame() {
      return run.orElseThrow().frame();
    }

    @Override
    public void pause() {
      run.orElseThrow().requestPause();
    }

    @Override
    public void halt() {
      run.orElseThrow().requestHalt();
    }

    @Override
    public Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd)
        throws ScriptError {
      return interpreter.enter(clearQueueOnEnter, clearOnEnd);
    }

    @Override
    public void endInterpreter() {
      interpreter.requestEnd();
    }

    @Override
    public void clearInterpreter() throws ScriptError {
      interpreter.requestClear();
    }
  }

  /** A secondary program has no interpreter mode and nothing to pause. */
  private static final class SecondaryControl implements ProgramControl {
    private boolean reachedOutside;

    @Override
    public void reachesOutside() throws ScriptError {
      if (reachedOutside) {
        throw new ScriptError("runtime-too-much-behind", text("secondarySendsTwice"));
      }
      reachedOutside = true;
    }

    @Override
    public boolean mayWait() {
      return false;
    }

    @Override
    public long frame() {
      return 0;
    }

    @Override
    public void pause() {}

    @Override
    public void halt() {}

    @Override
    public Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd)
        throws ScriptError {
      throw new ScriptError("not-in-secondary", text("secondaryCannotWait"));
    }

    @Override
    public void endInterpreter() {}

    @Override
    public void clearInterpreter() throws ScriptError {
      throw new ScriptError("no-interpreter", text("interpreterInactive"));
    }
  }
}
