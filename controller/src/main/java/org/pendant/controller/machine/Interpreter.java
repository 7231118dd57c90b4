package org.pendant.controller.machine;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.call.Builtins;
import org.pendant.controller.call.Outcome;
import org.pendant.controller.call.Wait;
import org.pendant.controller.value.NoneValue;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.Value;
import org.pendant.language.check.Checker;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement.Definition;

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
  public sealed interface Reply {
    /** Accepted under {@code id}, to be executed in turn. */
    record Acknowledged(int id) implements Reply {}

    /** Refused as a whole. */
    record Discarded(String reason) implements Reply {}
  }

  private record Line(int id, Script script) {}

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

  private final Builtins builtins;
  private final Deque<Line> queue = new ArrayDeque<>();
  private Optional<ProgramRun> run = Optional.empty();
  private Optional<Mode> mode = Optional.empty();
  private boolean endRequested;
  private boolean clearRequested;
  private int lastAccepted;
  private int lastExecuted;
  private int lastCleared;

  // What the lines interpreted so far have added to the program.
  private FunctionScope checkedScope;
  private FunctionScope linkedScope;
  private Program.Tables tables;
  private final IdentityHashMap<Definition, Integer> functionNumbers = new IdentityHashMap<>();
  private StaticSlots statics = new StaticSlots();
  private int firstStatic = -1;
  private int queuedBytes;
  private int resultSlot;
  private int newestThreadBefore;

  Interpreter(Builtins builtins) {
    this.builtins = builtins;
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
    forget(started.program().scopes().mainScope());
  }

  void programEnded() {
    dropQueue();
    mode = Optional.empty();
    run = Optional.empty();
  }

  /** The numbers of the functions that the program has by now. */
  IdentityHashMap<Definition, Integer> functionNumbers() {
    return functionNumbers;
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

  /** Drops the lines whose execution has not begun (manual 13.6). */
  public void skip() {
    dropQueue();
  }

  /**
   * Takes one line of one or more statements, all or nothing.
   *
   * @param text its bytes, one {@code char} each, without the line end
   */
  public Reply submit(String text) {
    if (run.isEmpty()) {
      return new Reply.Discarded("no program is running");
    }
    if (queue.size() >= MAX_QUEUED) {
      return new Reply.Discarded("more than " + MAX_QUEUED + " statements are waiting");
    }
    // a constant takes a byte and a separator at least, so the line cannot overflow its slots
    if (statics.names().size() + (queuedBytes + text.length()) / 2 >= STATIC_SLOTS - 64) {
      return new Reply.Discarded("interpreter mode is full, send clear_interpreter() first");
    }
    Source source = Source.of("interpreter", text.getBytes(StandardCharsets.ISO_8859_1));
    ParseResult parsed = ScriptParser.parseLine(source);
    List<Diagnostic> diagnostics = new ArrayList<>(parsed.diagnostics());
    if (diagnostics.stream().noneMatch(Diagnostic::isError)) {
      diagnostics.addAll(Checker.checkLine(parsed.script(), checkedScope, builtins));
    }
    Optional<Diagnostic> error = diagnostics.stream().filter(Diagnostic::isError).findFirst();
    if (error.isPresent()) {
      return new Reply.Discarded(error.get().message());
    }
    checkedScope = checkedScope.extendedBy(parsed.script().statements());
    lastAccepted = lastAccepted == Integer.MAX_VALUE ? 1 : lastAccepted + 1;
    queue.add(new Line(lastAccepted, parsed.script()));
    queuedBytes += text.length();
    return new Reply.Acknowledged(lastAccepted);
  }

  /** A built-in calls this in the thread that goes into interpreter mode. */
  Outcome enter(boolean clearQueueOnEnter, boolean clearOnEnd) throws ScriptError {
    ProgramRun running = run.orElseThrow();
    if (mode.isPresent()) {
      throw new ScriptError("nested-interpreter", "interpreter_mode is active already");
    }
    if (!running.runningMain()) {
      throw new ScriptError(
          "not-main-thread", "interpreter_mode can only be called in the main thread");
    }
    if (clearQueueOnEnter) {
      dropQueue();
    }
    endRequested = false;
    clearRequested = false;
    newestThreadBefore = running.newestThread();
    if (firstStatic < 0) {
      firstStatic = running.segments().take(STATIC_SLOTS);
    }
    ScriptThread main = running.main();
    forget(main.functions[main.depth - 1].scope());
    for (Line line : queue) {
      checkedScope = checkedScope.extendedBy(line.script().statements());
    }
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
      throw new ScriptError("no-interpreter", "clear_interpreter: interpreter mode is not active");
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
    if (clearRequested) {
      clearRequested = false;
      clear(main);
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
    lastExecuted = line.id();
    ScriptFunction base = main.functions[main.depth - 1];
    FunctionScope extended = linkedScope.extendedBy(line.script().statements());
    List<String> variables = variables(base, extended);
    List<String> before = variables(base, linkedScope);
    int known = statics.names().size();
    Linkage linkage = Linkage.after(tables, functionNumbers, statics);
    ScriptFunction compiled =
        Compiler.compileLine(
            line.script().source(),
            line.script().statements(),
            extended,
            variables,
            builtins,
            linkage);
    linkedScope = extended;
    tables = linkage.tables();
    functionNumbers.putAll(linkage.definitions());
    running.link(tables);
    running.fill(statics, known);
    running.pushLine(main, compiled, before.size());
    return true;
  }

  /**
   * The slots of an interpreted line: those of the function it runs in, temporaries included since
   * the call of interpreter_mode stands among them, then the interpreter's own variables.
   */
  private List<String> variables(ScriptFunction base, FunctionScope scope) {
    List<String> variables = new ArrayList<>(base.variables());
    while (variables.size() < base.slotCount()) {
      variables.add("");
    }
    List<String> locals = scope.locals();
    variables.addAll(locals.subList(base.scope().locals().size(), locals.size()));
    return variables;
  }

  private void dropQueue() {
    queue.clear();
    queuedBytes = 0;
  }

  private void clear(ScriptThread main) {
    lastCleared = lastExecuted;
    run.orElseThrow().killStartedAfter(newestThreadBefore);
    forget(main.functions[main.depth - 1].scope());
    for (Line line : queue) {
      checkedScope = checkedScope.extendedBy(line.script().statements());
    }
  }

  private void leave(boolean clearOnEnd) {
    ScriptThread main = run.orElseThrow().main();
    mode = Optional.empty();
    endRequested = false;
    if (clearOnEnd) {
      dropQueue();
      clear(main);
    }
  }

  /** Goes back to the program as it was compiled, seen from {@code scope}. */
  private void forget(FunctionScope scope) {
    Program program = run.orElseThrow().program();
    checkedScope = scope;
    linkedScope = scope;
    tables = program.tables();
    functionNumbers.clear();
    functionNumbers.putAll(program.functionNumbers());
    statics =
        new StaticSlots(
            Math.max(0, firstStatic),
            firstStatic + STATIC_SLOTS - 1,
            run.orElseThrow().globalSlots());
  }
}
