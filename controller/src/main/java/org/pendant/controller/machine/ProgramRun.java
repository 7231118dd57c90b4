package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.call.Builtin;
import org.pendant.controller.call.Builtins;
import org.pendant.controller.call.Call;
import org.pendant.controller.call.ProgramControl;
import org.pendant.controller.value.Registers;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.Value;

/**
 * One program while it runs: its values, its threads, and the scheduler that gives each runnable
 * thread its share of a frame (manual 10.2).
 */
final class ProgramRun {
  /** Most threads alive at once; one more is a runtime error. */
  static final int MAX_THREADS = 200;

  /**
   * Turns and calls that one thread may make in a frame: the computing time of its slice. It is
   * counted, not measured, so that every machine schedules alike.
   */
  static final int BUDGET = 50_000;

  private final Program program;
  private final Predicate<ScriptThread> nextLine;
  private final Registers registers;
  private final RegisterSegments segments;
  private final Methods methods;
  private final Processor processor;
  private final List<ScriptThread> threads = new ArrayList<>();
  private final List<ScriptThread> order = new ArrayList<>();
  private final BitSet killed = new BitSet();
  private Program.Tables tables;
  private ScriptFunction[] functions;
  private Builtin[] builtins;
  private int newestThread;
  private ScriptThread running;
  private long frame;
  private boolean haltRequested;
  private boolean pauseRequested;

  ProgramRun(
      Program program,
      Builtins builtins,
      ControlBox box,
      ProgramControl control,
      Predicate<ScriptThread> nextLine,
      Translation translation) {
    this.program = program;
    this.nextLine = nextLine;
    int statics = program.tables().staticNames().size();
    registers = new Registers(statics);
    segments = new RegisterSegments(registers, statics);
    methods = new Methods(builtins);
    link(program.tables());
    fill(0, tables.staticNames(), tables.staticValues(), 0);
    processor =
        new Processor(
            this,
            new Call(box, control, registers),
            new HotFunctions(translation, program.tables()));
    ScriptThread main = newThread(-1);
    main.push(functions[0], main.segmentStart, 0);
  }

  // --- what instructions refer to

  /** Takes over tables that begin with the present ones. */
  void link(Program.Tables linked) {
    tables = linked;
    functions = linked.functions().toArray(ScriptFunction[]::new);
    builtins = linked.builtins().toArray(Builtin[]::new);
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

  Registers registers() {
    return registers;
  }

  RegisterSegments segments() {
    return segments;
  }

  ScriptFunction[] functions() {
    return functions;
  }

  Builtin builtin(int number) {
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

  private ScriptThread newThread(int parent) {
    ScriptThread thread = new ScriptThread(newestThread++, parent);
    thread.segmentStart = segments.take(functions[0].slotCount());
    thread.segmentEnd = thread.segmentStart + RegisterSegments.sizeFor(functions[0].slotCount());
    thread.budget = BUDGET;
    threads.add(thread);
    order.add(thread);
    return thread;
  }

  /** Starts a thread that runs function {@code number}; {@link #newestThread} is its handle. */
  void startThread(int parent, int number) throws ScriptError {
    if (threads.size() >= MAX_THREADS) {
      throw new ScriptError(
          "too-many-threads", "more than " + MAX_THREADS + " threads run at once");
    }
    ScriptFunction function = functions[number];
    ScriptThread thread = newThread(parent);
    if (thread.segmentStart + function.slotCount() > thread.segmentEnd) {
      segments.enlarge(thread, thread.segmentStart + function.slotCount());
    }
    for (int i = 0; i < function.variableCount(); i++) {
      registers.clear(thread.segmentStart + i);
    }
    thread.push(function, thread.segmentStart, 0);
  }

  /** Whether the thread that runs just now is the main thread. */
  boolean runningMain() {
    return running == main();
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
    main.push(line, base, 0);
    main.state = ScriptThread.State.RUNNABLE;
  }

  int newestThread() {
    return newestThread - 1;
  }

  private Optional<ScriptThread> thread(int id) {
    for (ScriptThread thread : threads) {
      if (thread.id() == id) {
        return Optional.of(thread);
      }
    }
    return Optional.empty();
  }

  private void checkHandle(String statement, int id) throws ScriptError {
    if (id <= 0 || id >= newestThread) {
      throw new ScriptError(
          "unknown-thread", statement + ": " + id + " is not the handle of a thread");
    }
  }

  /** Makes {@code thread} wait for thread {@code id}; false when that has ended already. */
  boolean join(ScriptThread thread, int id) throws ScriptError {
    checkHandle("join", id);
    if (killed.get(id)) {
      throw new ScriptError("unknown-thread", "join: thread " + id + " was killed");
    }
    Optional<ScriptThread> other = thread(id);
    if (other.isEmpty()) {
      return false;
    }
    if (other.get().parentId() != thread.id()) {
      throw new ScriptError("not-a-child", "join: thread " + id + " was started by another thread");
    }
    thread.state = ScriptThread.State.JOINING;
    thread.joinedThread = id;
    return true;
  }

  /** Kills thread {@code id} and the threads it started; no effect when it has ended. */
  void kill(int id) throws ScriptError {
    checkHandle("kill", id);
    thread(id).ifPresent(this::killTree);
    killed.set(id);
  }

  private void killTree(ScriptThread thread) {
    end(thread);
    killed.set(thread.id());
    for (ScriptThread child : List.copyOf(threads)) {
      if (child.parentId() == thread.id()) {
        killTree(child);
      }
    }
  }

  private void end(ScriptThread thread) {
    if (thread.ended()) {
      return;
    }
    if (thread.state == ScriptThread.State.WAITING) {
      thread.wait.cancel();
    }
    thread.state = ScriptThread.State.ENDED;
    thread.critical = false;
    if (threads.size() > 1 && thread != main()) {
      threads.remove(thread);
      segments.give(thread.segmentStart, thread.segmentEnd - thread.segmentStart);
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

  /** How a frame left the program. */
  enum FrameResult {
    RUNNING,
    PAUSED,
    HALTED,
    FINISHED
  }

  /** Frames that this program has been running, pauses not counted. */
  long frame() {
    return frame;
  }

  /** A thread failed; {@code thread} tells where. */
  static final class ThreadFailure extends Exception {
    private static final long serialVersionUID = 1L;
    private final transient ScriptThread thread;
    private final ScriptError error;

    ThreadFailure(ScriptThread thread, ScriptError error) {
      super(error.getMessage(), error, false, false);
      this.thread = thread;
      this.error = error;
    }

    ScriptThread thread() {
      return thread;
    }

    ScriptError error() {
      return error;
    }
  }

  /**
   * Runs every runnable thread until it waits, ends or has used its slice. Those with the largest
   * slice left over go first.
   */
  FrameResult advance() throws ThreadFailure {
    frame++;
    if (order.size() > 1) {
      order.removeIf(ScriptThread::ended);
      order.sort(
          Comparator.comparing((ScriptThread t) -> !t.critical)
              .thenComparing(Comparator.comparingInt((ScriptThread t) -> t.budget).reversed())
              .thenComparingInt(ScriptThread::id));
    }
    for (int i = 0; i < order.size(); i++) {
      order.get(i).budget = BUDGET;
    }
    return rounds();
  }

  /** Goes round the threads until none can do more in this frame. */
  private FrameResult rounds() throws ThreadFailure {
    boolean progress = true;
    while (progress) {
      progress = false;
      // threads started meanwhile stand at the end and get their turn too
      for (int i = 0; i < order.size(); i++) {
        ScriptThread thread = order.get(i);
        if (!ready(thread)) {
          continue;
        }
        progress = true;
        FrameResult result = turn(thread);
        if (result != FrameResult.RUNNING) {
          return result;
        }
        if (thread.critical && thread.state == ScriptThread.State.RUNNABLE) {
          // out of its slice inside a critical section: nobody runs until it goes on
          return FrameResult.RUNNING;
        }
      }
    }
    return FrameResult.RUNNING;
  }

  private FrameResult turn(ScriptThread thread) throws ThreadFailure {
    Processor.Stop stop;
    running = thread;
    try {
      stop = processor.execute(thread);
    } catch (ScriptError e) {
      throw new ThreadFailure(thread, e);
    }
    switch (stop) {
      case WAITING -> {
        thread.state = ScriptThread.State.WAITING;
        thread.polledFrame = frame;
        thread.budget = 0;
      }
      case EXHAUSTED -> thread.budget = 0;
      case INTERPRETED -> {
        if (!nextLine.test(thread)) {
          thread.state = ScriptThread.State.WAITING;
          thread.polledFrame = frame;
          thread.budget = 0;
        }
      }
      case ENDED -> {
        boolean finished = thread == main();
        end(thread);
        if (finished) {
          return FrameResult.FINISHED;
        }
      }
      case HALTED -> {
        return FrameResult.HALTED;
      }
      case PAUSED -> {
        pauseRequested = false;
        return FrameResult.PAUSED;
      }
      case JOINING -> {}
      default -> throw new IllegalStateException("stopped: " + stop);
    }
    return FrameResult.RUNNING;
  }

  /** Whether {@code thread} can run now; looks at what it waits for, once a frame. */
  private boolean ready(ScriptThread thread) throws ThreadFailure {
    return switch (thread.state) {
      case RUNNABLE -> thread.budget > 0;
      case JOINING -> thread(thread.joinedThread).isEmpty() && released(thread);
      case WAITING -> thread.polledFrame != frame && waitOver(thread);
      case ENDED -> false;
    };
  }

  private static boolean released(ScriptThread thread) {
    thread.state = ScriptThread.State.RUNNABLE;
    return thread.budget > 0;
  }

  private boolean waitOver(ScriptThread thread) throws ThreadFailure {
    thread.polledFrame = frame;
    Optional<Value> result;
    try {
      result = thread.wait.poll(frame);
    } catch (ScriptError e) {
      throw new ThreadFailure(thread, e);
    }
    if (result.isEmpty()) {
      thread.budget = 0;
      return false;
    }
    registers.set(thread.bases[thread.depth - 1] + thread.waitResult, result.get());
    thread.state = ScriptThread.State.RUNNABLE;
    return true;
  }
}
