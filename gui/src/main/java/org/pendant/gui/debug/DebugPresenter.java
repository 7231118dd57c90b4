package org.pendant.gui.debug;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.debug.DebugState;
import org.pendant.controller.debug.Debugger;
import org.pendant.controller.debug.StopReason;
import org.pendant.controller.machine.Ending;
import org.pendant.controller.machine.ProgramState;
import org.pendant.controller.machine.ThreadSnapshot;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.editor.Execution;
import org.pendant.gui.session.Programs;
import org.pendant.gui.workbench.Workbench;
import org.pendant.language.source.ByteText;

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
  private final Stepping steps;
  private final ThreadWatch running;
  private final StartedProgram started = new StartedProgram();
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
    breakpoints = new BreakpointDesk(link, programs, started, workbench::notify);
    steps = new Stepping(link, started::toRun, workbench::notify);
    running = new ThreadWatch(link, () -> System.nanoTime() / 1_000_000, this::tellListeners);
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
    steps.refresh(state.debug(), program);
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
    steps.follow(selected);
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
    return debug.stop().map(stop -> StopText.of(stop, started::toNow)).orElse("");
  }

  /**
   * The threads of a program that is held, the main thread first; of one that runs where they were
   * when {@link #lookAtThreads} was called last.
   */
  public List<ThreadSnapshot> threads() {
    return held() ? debug.threads() : running.threads();
  }

  /** Whether a program runs and is not held. */
  boolean runsFree() {
    return program != ProgramState.STOPPED && !held();
  }

  /** Has the threads of a program that runs looked at, now and then. */
  void lookAtThreads() {
    running.refresh(program, held());
  }

  /** The line of the present text where a line of the running one is. */
  int lineNow(int line) {
    return started.toNow(line);
  }

  /** Where the program is in its text as that stands now. */
  public Execution execution(ControllerState state) {
    Optional<DebugState.Stop> stop = debug.stop().filter(each -> state.debug().held());
    if (stop.isEmpty()) {
      return ended(state).orElseGet(() -> Execution.running(started.toNow(state.program().line())));
    }
    boolean failed = stop.get().reason() instanceof StopReason.Failed;
    boolean there =
        selected
            .filter(scope -> scope.thread() == stop.get().thread())
            .filter(scope -> scope.depth() == depth(scope.thread()))
            .isPresent();
    return new Execution(
        executionLine(),
        failed && there ? Execution.State.FAILED : Execution.State.HELD,
        there ? StopText.atLine(stop.get()) : "");
  }

  /** A program that has failed shows where until its text is another. */
  private Optional<Execution> ended(ControllerState state) {
    return state
        .program()
        .ending()
        .filter(ending -> started.unchanged())
        .flatMap(
            ending ->
                ending instanceof Ending.Failed failed
                    ? Optional.of(
                        new Execution(
                            failed.failure().line(),
                            Execution.State.FAILED,
                            ByteText.decoded(failed.failure().message())))
                    : Optional.empty());
  }

  /** Shows the line where the program is held, in whichever program that is. */
  public void showHeld() {
    breakpoints.started().ifPresent(programs::select);
    if (executionLine() > 0) {
      workbench.showSource(executionLine(), 1);
    }
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
    steps.follow(selected);
    variables.load(scope);
    watchTree.load(scope);
    showHeld();
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
        .map(level -> started.toNow(level.line()))
        .orElse(0);
  }

  /** How the program is held and goes on. */
  public Stepping steps() {
    return steps;
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

  /** Tells {@code listener} when a program was held, went on, or another call is looked at. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tellListeners() {
    listeners.forEach(Runnable::run);
  }
}
