package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.coverage.CoverageMap;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Host;
import org.pendant.script.function.ProgramControl;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.function.Work;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Program run: one program while it runs: its values, its threads, and the scheduler that gives
 * each runnable thread its share of a frame (manual 10.2).
 */
final class ProgramRun {
  /** Most threads alive at once; one more is a runtime error. */
  static final int MAX_THREADS = 200;

  /** Most threads that a program may start from its beginning to its end. */
  private static final int MAX_STARTED = Integer.MAX_VALUE - 1;

  /** What programs keep in a variable that has no handle yet: as of a thread that has ended. */
  private static final int NO_THREAD = 0;

  private final Program program;
  private final Registers registers;
  private final RegisterSegments segments;
  private final Methods methods;
  private final Work work = new Work();
  private final ProgramMemory memory;
  private final HotFunctions hot;
  private final Processor processor;
  private final Scheduler scheduler;
  private final DebugHook debugHook;
  private final BreakpointPatches breakpointPatches;

  /** Not 0 for each coverage slot that was reached; empty without coverage. */
  private final byte[] marks;

  private final List<ScriptThread> threads = new ArrayList<>();
  private final BitSet killed = new BitSet();
  private Program.Tables tables;
  private ScriptFunction[] functions;
  private boolean trapped;
  private Builtin<?>[] builtins;
  private int links;
  private int newestThread;
  private boolean haltRequested;
  private boolean pauseRequested;

  ProgramRun(
      Program program,
      Builtins<?> builtins,
      Host host,
      ProgramControl control,
      Predicate<ScriptThread> nextLine,
      Translation translation,
      DebugHook debugHook,
      RunLimits limits) {
    this.program = program;
    marks = new byte[program.coverageMap().map(CoverageMap::slots).orElse(0)];
    memory = new ProgramMemory(limits.memoryBytes());
    this.debugHook = debugHook;
    breakpointPatches = new BreakpointPatches(program.source());
    int statics = program.tables().staticNames().size();
    registers = new Registers(statics);
    segments = new RegisterSegments(registers, statics);
    methods = new Methods(builtins);
    link(program.tables());
    fill(0, tables.staticNames(), tables.staticValues(), 0);
    hot = new HotFunctions(translation, program.tables());
    processor = new Processor(this, new Call<>(host, control, registers, work), hot);
    scheduler = new Scheduler(this, processor, nextLine, debugHook, limits.slices());
    startFunction(-1, functions[0]);
  }

  /** The same program with the same values, for {@link #onTheSide}. */
  private ProgramRun(
      ProgramRun original, Program.Tables linked, Host host, ProgramControl control) {
    program = original.program;
    marks = new byte[original.marks.length];
    memory = original.memory.fresh();
    debugHook = DebugHook.NONE;
    breakpointPatches = new BreakpointPatches(program.source());
    registers = copyOf(original.registers);
    segments = new RegisterSegments(registers, registers.size());
    methods = original.methods;
    link(linked);
    hot = new HotFunctions(Translation.NEVER, linked);
    processor = new Processor(this, new Call<>(host, control, registers, work), hot);
    scheduler = new Scheduler(this, processor, thread -> false, debugHook, Slices.NONE);
  }

  private static Registers copyOf(Registers registers) {
    int size = registers.size();
    Registers copy = new Registers(size);
    System.arraycopy(registers.numbers(), 0, copy.numbers(), 0, size);
    System.arraycopy(registers.tags(), 0, copy.tags(), 0, size);
    System.arraycopy(registers.objects(), 0, copy.objects(), 0, size);
    return copy;
  }

  /**
   * A run without threads to compute something on the side: its variables have the values that they
   * have here, lists and the like not copied.
   *
   * @param linked tables that begin with the present ones
   */
  ProgramRun onTheSide(Program.Tables linked, Host host, ProgramControl control) {
    return new ProgramRun(this, linked, host, control);
  }

  // --- what instructions refer to

  /** Takes over tables that begin with the present ones. */
  void link(Program.Tables linked) {
    tables = linked;
    links++;
    functions = linked.functions().toArray(ScriptFunction[]::new);
    breakpointPatches.replaceIn(functions);
    builtins = linked.builtins().toArray(Builtin<?>[]::new);
  }

  /** Puts the constants of {@code statics}, from number {@code known} on, into their slots. */
  void fill(StaticSlots statics, int known) {
    fill(statics.first(), statics.names(), statics.values(), known);
  }

  private void fill(int first, List<String> names, List<Value> values, int known) {
    for (int i = known; i < names.size(); i++) {
      if (names.get(i).isEmpty()) {
        registers.set(first + i, values.get(i));
      }
    }
  }

  Program program() {
    return program;
  }

  Program.Tables tables() {
    return tables;
  }

  /** How often tables were taken over. */
  int links() {
    return links;
  }

  /** Sets the traps anew, at once; no code may be running. */
  void trap(BreakpointPatches.Plan plan) {
    breakpointPatches.set(plan, functions, threads);
    trapped = breakpointPatches.wanted();
  }

  /** Whether functions may have traps. */
  boolean trapped() {
    return trapped;
  }

  Processor processor() {
    return processor;
  }

  /** A fault that a translation ended with since the last call of this; it does no harm. */
  Optional<Throwable> takeFault() {
    return hot.takeFault();
  }

  /** What counts the work that is done. */
  Work work() {
    return work;
  }

  ProgramMemory memory() {
    return memory;
  }

  Registers registers() {
    return registers;
  }

  RegisterSegments segments() {
    return segments;
  }

  ScriptFunction[] functions() {
    return functions;
  }

  Builtin<?> builtin(int number) {
    return builtins[number];
  }

  Methods methods() {
    return methods;
  }

  String name(int number) {
    return tables.names().get(number);
  }

  List<String> names(int number) {
    return tables.nameLists().get(number);
  }

  String staticName(int slot) {
    List<String> names = program.tables().staticNames();
    return slot < names.size() ? names.get(slot) : "";
  }

  /** Where its code marks what it reaches. */
  byte[] marks() {
    return marks;
  }

  /** What it has reached so far; empty for a program without coverage. */
  Optional<Coverage> coverage() {
    byte[] all = marks.clone();
    threads.forEach(thread -> markWhereItStands(thread, all));
    return program.coverage(all);
  }

  /** Marks the statements that a thread is in which leave no marks of their own. */
  private static void markWhereItStands(ScriptThread thread, byte[] marks) {
    for (int i = 0; marks.length > 0 && i < thread.depth; i++) {
      int slot = thread.functions[i].unmarked().reachedAt(thread.pcs[i]);
      if (slot != UnmarkedStatements.NONE) {
        marks[slot] = 1;
      }
    }
  }

  /** Copies of the global variables that have a value. */
  SortedMap<String, Value> globals() {
    SortedMap<String, Value> globals = new TreeMap<>();
    List<String> names = program.tables().staticNames();
    for (int slot = 0; slot < names.size(); slot++) {
      if (!names.get(slot).isEmpty() && registers.assigned(slot)) {
        globals.put(names.get(slot), registers.value(slot).copy());
      }
    }
    return globals;
  }

  // --- threads

  /** The main thread, whose end is the program's end. */
  ScriptThread main() {
    return threads.getFirst();
  }

  /** Starts a thread that runs function {@code number}; {@link #newestThread} is its handle. */
  void startThread(int parent, int number) throws ScriptError {
    if (threads.size() > MAX_THREADS) {
      throw new ScriptError("too-many-threads", text("tooManyThreads", MAX_THREADS));
    }
    if (newestThread >= MAX_STARTED) {
      throw new ScriptError("too-many-threads", text("tooManyStarted", MAX_STARTED));
    }
    segments.check(functions[number].slotCount());
    startFunction(parent, functions[number]);
  }

  private void startFunction(int parent, ScriptFunction function) {
    ScriptThread thread = new ScriptThread(newestThread++, parent, marks);
    thread.segmentStart = segments.take(function.slotCount());
    thread.segmentEnd = thread.segmentStart + RegisterSegments.sizeFor(function.slotCount());
    for (int i = 0; i < function.variableCount(); i++) {
      registers.clear(thread.segmentStart + i);
    }
    thread.push(function, thread.segmentStart, 0);
    threads.add(thread);
    scheduler.add(thread);
  }

  /** Whether the thread that runs just now is the main thread. */
  boolean runningMain() {
    return scheduler.isRunning(main());
  }

  /** What the thread that runs just now is at, or the main thread between turns. */
  ScriptPlace place() {
    return placeOf(scheduler.executing().orElse(main()));
  }

  /** What {@code thread} is at. */
  ScriptPlace placeOf(ScriptThread thread) {
    if (thread.depth == 0) {
      return new ScriptPlace(program.source().name(), thread.id(), program.name(), 1);
    }
    return new ScriptPlace(
        thread.functions[thread.depth - 1].source().name(),
        thread.id(),
        thread.functions[0].name(),
        thread.line());
  }

  /** The static slot of each global variable. */
  Map<String, Integer> globalSlots() {
    Map<String, Integer> slots = new HashMap<>();
    List<String> names = program.tables().staticNames();
    for (int slot = 0; slot < names.size(); slot++) {
      if (!names.get(slot).isEmpty()) {
        slots.put(names.get(slot), slot);
      }
    }
    return slots;
  }

  /**
   * Lets {@code main} execute an interpreted line in the slots of its innermost function.
   *
   * @param knownVariables how many of the line's variables other lines had before
   */
  void pushLine(ScriptThread main, ScriptFunction line, int knownVariables) {
    int base = main.bases[main.depth - 1];
    if (base + line.slotCount() > main.segmentEnd) {
      segments.enlarge(main, base + line.slotCount());
      base = main.bases[main.depth - 1];
    }
    for (int i = knownVariables; i < line.variableCount(); i++) {
      registers.clear(base + i);
    }
    main.lineSlots = base + line.variableCount() - main.segmentStart;
    main.budget -= Cost.LINE_NS;
    main.push(breakpointPatches.entered(line), base, 0);
    main.state = ScriptThread.State.RUNNABLE;
  }

  int newestThread() {
    return newestThread - 1;
  }

  /** The thread with handle {@code id}, unless it has ended. */
  Optional<ScriptThread> thread(int id) {
    for (ScriptThread thread : threads) {
      if (thread.id() == id) {
        return Optional.of(thread);
      }
    }
    return Optional.empty();
  }

  /** The threads that have not ended, the main thread first. */
  List<ScriptThread> threads() {
    return Collections.unmodifiableList(threads);
  }

  private void checkHandle(String statement, int id) throws ScriptError {
    if (id < 0 || id >= newestThread) {
      throw new ScriptError("unknown-thread", text("unknownThread", statement, id));
    }
  }

  /** Makes {@code thread} wait for thread {@code id}; false when that has ended already. */
  boolean join(ScriptThread thread, int id) throws ScriptError {
    checkHandle("join", id);
    if (id == NO_THREAD) {
      return false;
    }
    if (killed.get(id)) {
      throw new ScriptError("unknown-thread", text("joinOfKilled", id));
    }
    Optional<ScriptThread> other = thread(id);
    if (other.isEmpty()) {
      return false;
    }
    if (other.get().parentId() != thread.id()) {
      throw new ScriptError("not-a-child", text("joinOfOther", id));
    }
    thread.state = ScriptThread.State.JOINING;
    thread.joined = other;
    return true;
  }

  /** Kills thread {@code id} and the threads it started; no effect when it has ended. */
  void kill(int id) throws ScriptError {
    checkHandle("kill", id);
    if (id == NO_THREAD) {
      return;
    }
    thread(id).ifPresent(this::killTree);
    killed.set(id);
  }

  /** Ends {@code thread} and the threads it started. */
  void killTree(ScriptThread thread) {
    end(thread);
    killed.set(thread.id());
    for (ScriptThread child : List.copyOf(threads)) {
      if (child.parentId() == thread.id()) {
        killTree(child);
      }
    }
  }

  void end(ScriptThread thread) {
    if (thread.ended()) {
      return;
    }
    if (thread.state == ScriptThread.State.WAITING) {
      thread.wait.cancel();
    }
    markWhereItStands(thread, marks);
    thread.state = ScriptThread.State.ENDED;
    thread.critical = false;
    if (threads.size() > 1 && thread != main()) {
      threads.remove(thread);
      scheduler.remove(thread);
      segments.give(thread.segmentStart, thread.segmentEnd - thread.segmentStart);
      debugHook.threadEnded(thread.id());
    }
  }

  /** Kills the threads that the main thread started with a handle above {@code last}. */
  void killStartedAfter(int last) {
    for (ScriptThread thread : List.copyOf(threads)) {
      if (thread.parentId() == main().id() && thread.id() > last) {
        killTree(thread);
      }
    }
  }

  /** Ends every thread. */
  void endAll() {
    for (ScriptThread thread : List.copyOf(threads).reversed()) {
      end(thread);
    }
  }

  // --- the frame

  void requestHalt() {
    haltRequested = true;
  }

  void requestPause() {
    pauseRequested = true;
  }

  boolean haltRequested() {
    return haltRequested;
  }

  boolean pauseRequested() {
    return pauseRequested;
  }

  /** A pause that a built-in asked for has come about. */
  void pauseIsUnderWay() {
    pauseRequested = false;
  }

  /** Frames that this program has been running, pauses not counted. */
  long frame() {
    return scheduler.frame();
  }

  /** Whether a frame has begun and is not over. */
  boolean heldInFrame() {
    return scheduler.held();
  }

  /** Runs all threads for one frame, or continues with the one that was paused. */
  Scheduler.FrameResult advance() throws ThreadFailure {
    if (!scheduler.held()) {
      breakpointPatches.settle(threads);
    }
    return scheduler.advance();
  }
}
