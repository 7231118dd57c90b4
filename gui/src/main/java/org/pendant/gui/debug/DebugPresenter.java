package org.pendant.gui.debug;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.debug.DebugState;
import org.pendant.controller.debug.Debugger;
import org.pendant.controller.debug.StopReason;
import org.pendant.controller.machine.ProgramState;
import org.pendant.controller.machine.ThreadSnapshot;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.value.ScriptError;
import org.pendant.gui.session.Programs;
import org.pendant.gui.workbench.Workbench;

/**
 * Where the program is held, which call of it is looked at, and how it goes on. It has no Swing;
 * one thread uses it, the dispatch thread.
 */
public final class DebugPresenter {
  /** Frames for which values stay in sight after a program went on: a step is mostly over then. */
  private static final long LINGER_FRAMES = 100;

  private final Workbench workbench;
  private final Programs programs;
  private final DebugLink link;
  private final BreakpointDesk breakpoints;
  private final ValueTree variables;
  private final Watches watches;
  private final ValueTree watchTree;
  private final List<Runnable> listeners = new ArrayList<>();
  private DebugState debug = DebugState.FREE;
  private ProgramState program = ProgramState.STOPPED;
  private Optional<Scope> selected = Optional.empty();
  private long stopNumber;
  private long heldFrame;
  private boolean lingering;

  /** Asks the debugger of the workbench's session. */
  public DebugPresenter(Workbench workbench, Programs programs) {
    this(
        workbench,
        programs,
        new SessionLink(command -> workbench.session().submit(command), EventQueue::invokeLater));
  }

  DebugPresenter(Workbench workbench, Programs programs, DebugLink link) {
    this.workbench = workbench;
    this.programs = programs;
    this.link = link;
    breakpoints = new BreakpointDesk(link, programs, workbench::notify);
    variables = new ValueTree(link, DebugPresenter::readVariables, this::reloadValues);
    watches = new Watches(workbench.settings());
    watchTree =
        new ValueTree(
            link,
            (reader, scope) -> Watches.read(watches.expressions(), reader, scope),
            this::reloadValues);
    watchTree.clear(watches.idle());
  }

  private static List<ValueNode.Group> readVariables(ValueReader reader, Scope scope) {
    Debugger debugger = reader.debugger();
    List<ValueNode.Group> groups = new ArrayList<>();
    List<ValueNode> locals = reader.read(scope, debugger.variables(scope.thread(), scope.depth()));
    if (!locals.isEmpty()) {
      groups.add(new ValueNode.Group("Local in " + scope.function(), scope, locals));
    }
    groups.add(
        new ValueNode.Group("Global", Scope.GLOBAL, reader.read(Scope.GLOBAL, debugger.globals())));
    return groups;
  }

  // --- what is shown

  /** Takes the newest snapshot; the same one again changes nothing. */
  public void refresh(ControllerState state) {
    boolean same = state.debug().equals(debug) && state.program().state() == program;
    program = state.program().state();
    if (state.debug().held()) {
      heldFrame = state.frame();
    }
    if (!same) {
      DebugState before = debug;
      debug = state.debug();
      if (debug.held()) {
        hold(before);
      } else if (before.held()) {
        lingering = true;
      }
      tellListeners();
    }
    if (lingering && !held() && over(state)) {
      letGo();
      tellListeners();
    }
  }

  private boolean over(ControllerState state) {
    return program == ProgramState.STOPPED
        || state.frame() < heldFrame
        || state.frame() - heldFrame > LINGER_FRAMES;
  }

  private void hold(DebugState before) {
    DebugState.Stop stop = debug.stop().orElseThrow();
    lingering = false;
    boolean fresh = stop.number() != stopNumber || !before.held();
    if (fresh) {
      stopNumber = stop.number();
      variables.stopped();
      watchTree.stopped();
      breakpoints.reload();
    }
    if (fresh || selected.filter(this::exists).isEmpty()) {
      select(stop.thread(), depth(stop.thread()));
    }
  }

  private void letGo() {
    lingering = false;
    selected = Optional.empty();
    variables.clear(List.of());
    watchTree.clear(watches.idle());
  }

  private boolean exists(Scope scope) {
    return thread(scope.thread()).filter(each -> scope.depth() <= each.stack().size()).isPresent();
  }

  private Optional<ThreadSnapshot> thread(int id) {
    return debug.threads().stream().filter(each -> each.id() == id).findFirst();
  }

  private int depth(int thread) {
    return thread(thread).map(each -> each.stack().size()).orElse(Debugger.OUTERMOST);
  }

  /** Whether a program is held. */
  public boolean held() {
    return debug.held();
  }

  /** Whether there are values to show: also for a moment after a program went on. */
  public boolean showsValues() {
    return held() || lingering;
  }

  /** Why the program is held; empty while it is not. */
  public String stopText() {
    return debug.stop().map(StopText::of).orElse("");
  }

  /** The threads of a program that is held, the main thread first. */
  public List<ThreadSnapshot> threads() {
    return debug.threads();
  }

  /** The call that is looked at. */
  public Optional<Scope> selected() {
    return selected;
  }

  /** Looks at a call; {@code depth} is 1 for the outermost. */
  public void select(int thread, int depth) {
    Optional<ThreadSnapshot> wanted = thread(thread);
    if (wanted.isEmpty() || depth < 1 || depth > wanted.get().stack().size()) {
      return;
    }
    ThreadSnapshot.Level level = level(wanted.get(), depth);
    Scope scope = new Scope(thread, depth, level.function());
    selected = Optional.of(scope);
    variables.load(scope);
    watchTree.load(scope);
    breakpoints.started().ifPresent(programs::select);
    if (executionLine() > 0) {
      workbench.showSource(executionLine(), 1);
    }
    tellListeners();
  }

  private static ThreadSnapshot.Level level(ThreadSnapshot thread, int depth) {
    return thread.stack().get(thread.stack().size() - depth);
  }

  /**
   * The line of the program's text where the call that is looked at stands; 0 while nothing is
   * held, and for lines of interpreter mode.
   */
  public int executionLine() {
    return selected
        .filter(scope -> held())
        .flatMap(scope -> thread(scope.thread()).map(each -> level(each, scope.depth())))
        .filter(level -> !level.source().equals("interpreter"))
        .map(ThreadSnapshot.Level::line)
        .orElse(0);
  }

  /** Breakpoints of the open programs. */
  public BreakpointDesk breakpoints() {
    return breakpoints;
  }

  ValueTree variables() {
    return variables;
  }

  ValueTree watchTree() {
    return watchTree;
  }

  // --- watches

  /** Computes an expression at every stop from now on. */
  public void addWatch(String expression) {
    watches.add(expression);
    reloadWatches();
  }

  /** Replaces a watched expression; blank text removes it. */
  public void changeWatch(String from, String to) {
    watches.change(from, to);
    reloadWatches();
  }

  /** The watched expressions. */
  public List<String> watches() {
    return watches.expressions();
  }

  private void reloadWatches() {
    if (held()) {
      watchTree.reload();
    } else {
      watchTree.clear(watches.idle());
    }
  }

  private void reloadValues() {
    variables.reload();
    watchTree.reload();
  }

  // --- going on

  /** Whether a held program can go on by steps; one that has failed can only end. */
  public boolean canStep() {
    return debug.stop().filter(stop -> !(stop.reason() instanceof StopReason.Failed)).isPresent();
  }

  /** Whether there is a program to hold. */
  public boolean canPause() {
    return program == ProgramState.RUNNING && !held();
  }

  /** Lets the program go on; one that has failed ends. */
  public void resume() {
    send(debugger -> debugger.resume());
  }

  /** Holds the program before its next statement. */
  public void pause() {
    send(debugger -> debugger.pause());
  }

  /** To the next statement of the thread, in any function. */
  public void stepInto() {
    int thread = steppedThread();
    send(debugger -> debugger.stepInto(thread));
  }

  /** To the next statement of the same function. */
  public void stepOver() {
    int thread = steppedThread();
    send(debugger -> debugger.stepOver(thread));
  }

  /** To the next statement of the caller. */
  public void stepOut() {
    int thread = steppedThread();
    send(debugger -> debugger.stepOut(thread));
  }

  /** To a line of the program's text, from 1. */
  public void runTo(int line) {
    int thread = steppedThread();
    send(debugger -> debugger.runTo(thread, line));
  }

  /** Ends a thread of a held program, and those that it started. */
  public void kill(int thread) {
    send(debugger -> debugger.kill(thread));
  }

  private int steppedThread() {
    return selected.map(Scope::thread).orElse(Debugger.MAIN);
  }

  /** Something that the debugger has to do. */
  @FunctionalInterface
  private interface Deed {
    void on(Debugger debugger) throws ScriptError;
  }

  private void send(Deed deed) {
    link.ask(
        debugger -> {
          deed.on(debugger);
          return true;
        },
        done -> {},
        why -> workbench.notify("Refused: " + why));
  }

  /** Tells {@code listener} when a program was held, went on, or another call is looked at. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tellListeners() {
    listeners.forEach(Runnable::run);
  }
}
