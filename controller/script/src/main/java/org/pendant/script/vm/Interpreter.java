package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.pendant.language.check.Checker;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Interpreter mode (manual 13): lines received while a program runs are linked into it and executed
 * in the scope that called {@code interpreter_mode()}.
 *
 * <p>Lines are checked when they arrive and linked just before they run. New variables in them are
 * local to interpreter mode; new functions are visible to later lines.
 */
public final class Interpreter {
  /** Most lines that wait at once; one more is discarded. */
  public static final int MAX_QUEUED = 10_000;

  /** Constants that the lines between two clears may use. */
  private static final int STATIC_SLOTS = 32_768;

  /** The answer to a line. */
  public sealed interface Response {
    /** Accepted under {@code id}, to be executed in turn. */
    record Acknowledged(int id) implements Response {}

    /** Refused as a whole. */
    record Discarded(String reason) implements Response {}
  }

  private record Line(int id, Script script, boolean clears) {}

  /** What {@code interpreter_mode()} waits for. */
  private final class Mode implements Wait {
    private final boolean clearOnEnd;

    Mode(boolean clearOnEnd) {
      this.clearOnEnd = clearOnEnd;
    }

    @Override
    public Optional<Value> poll(long frame) {
      if (!endRequested) {
        return Optional.empty();
      }
      leave(clearOnEnd);
      return Optional.of(NoneValue.NONE);
    }
  }

  private final Builtins<?> builtins;
  private final Consumer<String> warnings;
  private final InterpreterJournal journal = new InterpreterJournal();
  private final Deque<Line> queue = new ArrayDeque<>();

  /** How many of the lines that wait may clear what is before them. */
  private int clearsQueued;

  /** Whether the line that is being executed may do so. */
  private boolean clearUnderWay;

  private Optional<ProgramRun> run = Optional.empty();
  private Optional<Mode> mode = Optional.empty();
  private boolean endRequested;
  private boolean clearRequested;
  private int lastAccepted;
  private int lastExecuted;
  private int lastCleared;

  // What the lines interpreted so far have added to the program.
  private FunctionScope checkedScope;
  private LineLinks links;

  /** What of it outlives a clearing: all that modes with {@code clearOnEnd = False} have left. */
  private LineLinks kept;

  private int firstStatic = -1;
  private int queuedBytes;
  private int resultSlot;
  private int newestThreadBefore;

  /**
   * Not in interpreter mode.
   *
   * @param warnings are told which accepted lines had to be dropped
   */
  Interpreter(Builtins<?> builtins, Consumer<String> warnings) {
    this.builtins = builtins;
    this.warnings = warnings;
  }

  void programStarted(ProgramRun started) {
    run = Optional.of(started);
    dropQueue();
    mode = Optional.empty();
    endRequested = false;
    lastAccepted = 0;
    lastExecuted = 0;
    lastCleared = 0;
    firstStatic = -1;
    clearUnderWay = false;
    journal.add(new InterpreterEvent.ProgramStarted(started.program().name()));
    kept = nothing();
    forget();
  }

  void programEnded() {
    dropQueue();
    clearUnderWay = false;
    mode = Optional.empty();
    run = Optional.empty();
  }

  /** The numbers of the functions that the program has by now. */
  IdentityHashMap<Definition, Integer> functionNumbers() {
    return links.functionNumbers();
  }

  /** The first static slot that neither the program nor interpreted lines use. */
  int firstFreeStatic() {
    return firstStatic < 0
        ? run.orElseThrow().program().tables().staticNames().size()
        : firstStatic + STATIC_SLOTS;
  }

  /** Whether {@code interpreter_mode()} is active. */
  public boolean active() {
    return mode.isPresent();
  }

  /** The largest id of a line whose execution has begun; 0 for none. */
  public int lastExecuted() {
    return lastExecuted;
  }

  /** The largest id that was accepted; 0 for none. */
  public int lastInterpreted() {
    return lastAccepted;
  }

  /** The largest id that was cleared; 0 for none. */
  public int lastCleared() {
    return lastCleared;
  }

  /** How many accepted lines wait for their execution. */
  public int unexecuted() {
    return queue.size();
  }

  /**
   * Whether lines that arrive now have to wait with their check: one before them may clear what
   * they refer to (manual 13.4).
   */
  public boolean clearing() {
    return mode.isPresent() && (clearUnderWay || clearsQueued > 0);
  }

  /** What has happened; any thread. */
  public InterpreterJournal journal() {
    return journal;
  }

  /** All of this at once. */
  public InterpreterStatus status() {
    return new InterpreterStatus(active(), lastExecuted, lastAccepted, lastCleared, unexecuted());
  }

  /** Drops the lines whose execution has not begun (manual 13.6). */
  public void skip() {
    dropQueue();
  }

  /**
   * Takes one line of one or more statements, all or nothing.
   *
   * @param text its bytes, one {@code char} each, without the line end
   */
  public Response submit(String text) {
    return submit(InterpretedLine.read(text));
  }

  /** As {@link #submit(String)}, for a line that has been read already. */
  public Response submit(InterpretedLine line) {
    String text = line.text();
    if (run.isEmpty()) {
      return new Response.Discarded(text("noneRunning"));
    }
    if (queue.size() >= MAX_QUEUED) {
      return new Response.Discarded(text("queueFull", MAX_QUEUED));
    }
    // a constant takes a byte and a separator at least, so the line cannot overflow its slots
    if (links.statics() + (queuedBytes + text.length()) / 2 >= STATIC_SLOTS - 64) {
      return new Response.Discarded(text("interpreterFull"));
    }
    ParseResult parsed = line.parsed();
    List<Diagnostic> diagnostics = new ArrayList<>(parsed.diagnostics());
    if (diagnostics.stream().noneMatch(Diagnostic::isError)) {
      diagnostics.addAll(Checker.checkLine(parsed.script(), checkedScope, builtins));
    }
    Optional<Diagnostic> error = diagnostics.stream().filter(Diagnostic::isError).findFirst();
    if (error.isPresent()) {
      return new Response.Discarded(error.get().message());
    }
    checkedScope = checkedScope.extendedBy(parsed.script().statements());
    lastAccepted = lastAccepted == Integer.MAX_VALUE ? 1 : lastAccepted + 1;
    queue.add(new Line(lastAccepted, parsed.script(), line.clears()));
    clearsQueued += line.clears() ? 1 : 0;
    queuedBytes += text.length();
    journal.add(new InterpreterEvent.Accepted(lastAccepted, lastExecuted, text));
    return new Response.Acknowledged(lastAccepted);
  }

  /** A built-in calls this in the thread that goes into interpreter mode. */
  Outcome enter(boolean clearQueueOnEnter, boolean clearOnEnd) throws ScriptError {
    ProgramRun running = run.orElseThrow();
    if (mode.isPresent()) {
      throw new ScriptError("nested-interpreter", text("interpreterActive"));
    }
    if (!running.runningMain()) {
      throw new ScriptError("not-main-thread", text("interpreterNotMain"));
    }
    if (clearQueueOnEnter) {
      dropQueue();
    }
    endRequested = false;
    clearRequested = false;
    newestThreadBefore = running.newestThread();
    if (firstStatic < 0) {
      firstStatic = running.segments().take(STATIC_SLOTS);
      kept = nothing();
    }
    ScriptThread main = running.main();
    kept = kept.in(main.functions[main.depth - 1].scope());
    forget();
    checkQueue();
    Mode entered = new Mode(clearOnEnd);
    mode = Optional.of(entered);
    return entered;
  }

  void requestEnd() {
    if (mode.isPresent()) {
      endRequested = true;
    }
  }

  void requestClear() throws ScriptError {
    if (mode.isEmpty()) {
      throw new ScriptError("no-interpreter", text("interpreterInactive"));
    }
    clearRequested = true;
  }

  /** Gives an idle interpreting thread its next line at the start of a frame. */
  void feed(ScriptThread main) {
    if (mode.isPresent()
        && main.state == ScriptThread.State.WAITING
        && main.wait == mode.get()
        && !endRequested
        && !queue.isEmpty()) {
      resultSlot = main.waitResult;
      link(main);
    }
  }

  /**
   * A line was executed to its end: links the next one into {@code main}, or lets it wait for more.
   */
  boolean next(ScriptThread main) {
    clearUnderWay = false;
    if (clearRequested) {
      clearRequested = false;
      clear();
    }
    if (!endRequested && !queue.isEmpty()) {
      return link(main);
    }
    main.wait = mode.orElseThrow();
    main.waitResult = resultSlot;
    return false;
  }

  private boolean link(ScriptThread main) {
    ProgramRun running = run.orElseThrow();
    Line line = queue.remove();
    queuedBytes -= line.script().source().text().length();
    if (line.clears()) {
      clearsQueued--;
      clearUnderWay = true;
    }
    lastExecuted = line.id();
    links.link(running, main, line.script(), builtins, UnaryOperator.identity());
    return true;
  }

  /** How many registers are kept for lines, most of them empty. */
  int keptRegisters() {
    return firstStatic < 0 ? 0 : STATIC_SLOTS;
  }

  /** Runs the lines that wait on the side, one after the other. */
  interface Preview {
    /**
     * Lets a copy of the main thread, run in {@code side}, execute the next line that waits.
     *
     * @return false if there is none, or it may change what is known of those after it
     */
    boolean next(ProgramRun side, ScriptThread main);
  }

  /**
   * The lines that wait now, for a copy of {@code thread}.
   *
   * @param as what becomes of the tables that the other run gets
   */
  Preview preview(ScriptThread thread, UnaryOperator<Program.Tables> as) {
    if (mode.isEmpty() || queue.isEmpty() || endRequested || thread != run.orElseThrow().main()) {
      return (side, main) -> false;
    }
    LineLinks onTheSide = links.copy();
    Iterator<Line> waiting = queue.iterator();
    return (side, main) -> {
      Optional<Line> line = waiting.hasNext() ? Optional.of(waiting.next()) : Optional.empty();
      if (line.isEmpty() || line.get().clears()) {
        return false;
      }
      onTheSide.link(side, main, line.get().script(), builtins, as);
      return true;
    };
  }

  private void dropQueue() {
    queue.clear();
    queuedBytes = 0;
    clearsQueued = 0;
  }

  /** The lines that wait meet another scope than the one they were checked in. */
  private void checkQueue() {
    List<Line> waiting = List.copyOf(queue);
    dropQueue();
    for (Line line : waiting) {
      Optional<Diagnostic> error =
          Checker.checkLine(line.script(), checkedScope, builtins).stream()
              .filter(Diagnostic::isError)
              .findFirst();
      if (error.isPresent()) {
        warnings.accept(text("statementDropped", line.id(), error.get().message()));
      } else {
        checkedScope = checkedScope.extendedBy(line.script().statements());
        queue.add(line);
        clearsQueued += line.clears() ? 1 : 0;
        queuedBytes += line.script().source().text().length();
      }
    }
  }

  private void clear() {
    lastCleared = lastExecuted;
    journal.add(new InterpreterEvent.Cleared());
    ProgramRun running = run.orElseThrow();
    running.killStartedAfter(newestThreadBefore);
    links.takeValues(running.registers(), running.main());
    kept.takeValues(links);
    forget();
    checkQueue();
  }

  private void leave(boolean clearOnEnd) {
    mode = Optional.empty();
    endRequested = false;
    clearUnderWay = false;
    if (clearOnEnd) {
      dropQueue();
      clear();
    } else {
      ProgramRun running = run.orElseThrow();
      links.takeValues(running.registers(), running.main());
      kept = links.copy();
      journal.add(new InterpreterEvent.Kept());
    }
  }

  /** Goes back to what outlives a clearing. */
  private void forget() {
    links = kept.copy();
    checkedScope = links.scope();
  }

  /** The program as it was compiled. */
  private LineLinks nothing() {
    ProgramRun running = run.orElseThrow();
    Program program = running.program();
    return new LineLinks(
        program.scopes().mainScope(),
        program.tables(),
        new IdentityHashMap<>(program.functionNumbers()),
        new StaticSlots(
            Math.max(0, firstStatic), firstStatic + STATIC_SLOTS - 1, running.globalSlots()));
  }
}
