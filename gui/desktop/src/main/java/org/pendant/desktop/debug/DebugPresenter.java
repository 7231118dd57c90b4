package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Debugger presenter: where the program is paused, which call of it is looked at, and how it
 * continues. It has no Swing; one thread uses it, the dispatch thread.
 */
public final class DebugPresenter {
  /**
   * Frames for which values stay in sight after a program continued: a step is mostly over then.
   */
  private static final long LINGER_FRAMES = 100;

  /** How often breakpoints are asked for their hits while these are in sight. */
  private static final long HITS_PERIOD_MS = 500;

  private final Workbench workbench;
  private final Supplier<String> controller;
  private final Programs programs;
  private final OpenBreakpoints breakpoints;
  private final Stepping steps;
  private final ThreadWatch running;
  private final BusyWatch busy;
  private final StartedProgram started = new StartedProgram();
  private final HeldProgram held = new HeldProgram(started);
  private final ValueTree variables;
  private final Watches watches;
  private final ValueTree watchTree;
  private final List<Runnable> listeners = new ArrayList<>();
  private ProgramState program = ProgramState.STOPPED;
  private long stopNumber;
  private long heldFrame;
  private boolean lingering;
  private long hitsAskedMs = System.nanoTime() / 1_000_000 - HITS_PERIOD_MS;

  /** The controller whose snapshots came last. */
  private String shown;

  /** Asks the debugger of the workbench's session. */
  public DebugPresenter(Workbench workbench, Programs programs) {
    this(
        workbench,
        programs,
        new SessionLink(command -> workbench.session().submit(command), EventQueue::invokeLater),
        () -> workbench.session().shown().name());
  }

  /**
   * As above.
   *
   * @param controller the name of the controller that is shown
   */
  DebugPresenter(
      Workbench workbench, Programs programs, DebugLink link, Supplier<String> controller) {
    this.workbench = workbench;
    this.controller = controller;
    shown = controller.get();
    this.programs = programs;
    breakpoints = new OpenBreakpoints(link, programs, started, workbench::notify);
    steps = new Stepping(link, started::toRun, workbench::notify);
    running = new ThreadWatch(link, () -> System.nanoTime() / 1_000_000, this::tellListeners);
    busy = new BusyWatch(link, () -> System.nanoTime() / 1_000_000);
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
      groups.add(new ValueNode.Group(text("localIn", scope.function()), scope, locals));
    }
    groups.add(
        new ValueNode.Group(
            text("global"), Scope.GLOBAL, reader.read(Scope.GLOBAL, debugger.globals())));
    return groups;
  }

  // --- what is shown

  /** Takes the newest snapshot; the same one again changes nothing. */
  public void refresh(ControllerState state) {
    boolean same = state.debug().equals(held.debug()) && state.program().state() == program;
    program = state.program().state();
    steps.refresh(state);
    if (state.debug().held()) {
      heldFrame = state.frame();
    }
    if (!same) {
      boolean before = held();
      held.show(state.debug());
      if (held()) {
        hold(before);
      } else if (before) {
        lingering = true;
      }
      tellListeners();
    }
    boolean other = !controller.get().equals(shown);
    shown = controller.get();
    if (lingering && !held() && (other || over(state))) {
      letGo();
      tellListeners();
    }
  }

  private boolean over(ControllerState state) {
    return program == ProgramState.STOPPED
        || state.frame() < heldFrame
        || state.frame() - heldFrame > LINGER_FRAMES;
  }

  private void hold(boolean before) {
    DebugState.Stop stop = held.debug().stop().orElseThrow();
    lingering = false;
    boolean fresh = stop.number() != stopNumber || !before;
    if (fresh) {
      stopNumber = stop.number();
      variables.stopped();
      watchTree.stopped();
      breakpoints.reload();
    }
    if (fresh || !held.selectionExists()) {
      select(stop.thread(), held.depth(stop.thread()));
    }
  }

  private void letGo() {
    lingering = false;
    held.selectNothing();
    steps.follow(held.selected());
    variables.clear(List.of());
    watchTree.clear(watches.idle());
  }

  /** Whether a program is paused. */
  public boolean held() {
    return held.held();
  }

  /** Whether there are values to show: also for a moment after a program continued. */
  public boolean showsValues() {
    return held() || lingering;
  }

  /** Why the program is paused; empty while it is not. */
  public String stopText() {
    return held.stopText();
  }

  /** Why the program was paused at a stop. */
  String stopText(DebugState.Stop stop) {
    return held.stopText(stop);
  }

  /**
   * Names the places where programs are paused, and their calls.
   *
   * @param names what a line of the running text is called within a sentence
   */
  public void nameLinesBy(IntFunction<String> names) {
    held.nameLinesBy(names);
  }

  /** What a line of the running text is called in a sentence. */
  String place(int line) {
    return held.place(line);
  }

  /**
   * The threads of a program that is paused, the main thread first; of one that runs where they
   * were when {@link #lookAtThreads} was called last.
   */
  public List<ThreadSnapshot> threads() {
    return held() ? held.threads() : running.threads();
  }

  /** Whether a program runs and is not paused. */
  boolean runsFree() {
    return program != ProgramState.STOPPED && !held();
  }

  /** Has the hits of breakpoints looked at, now and then: those that stop nothing count as well. */
  void lookAtHits() {
    long nowMs = System.nanoTime() / 1_000_000;
    if (nowMs - hitsAskedMs >= HITS_PERIOD_MS && !breakpoints.all().isEmpty()) {
      hitsAskedMs = nowMs;
      breakpoints.reload();
    }
  }

  /** Has the threads of a program that runs looked at, now and then. */
  public void lookAtThreads() {
    running.refresh(program, held());
  }

  /** Looks, now and then, whether the program that runs waits at times. */
  public void lookForBusyThreads() {
    busy.refresh(runsFree());
  }

  /** A thread that has not waited for a second of robot time, as seen last. */
  public Optional<ThreadSnapshot> busyThread() {
    return busy.busy();
  }

  /** The line of the present text where a line of the running one is. */
  public int lineNow(int line) {
    return started.toNow(line);
  }

  /** Where the program is in its text as that stands now. */
  public Execution execution(ControllerState state) {
    return held.execution(state);
  }

  /** Shows the line where the program is paused, in whichever program that is. */
  public void showHeld() {
    breakpoints.started().ifPresent(programs::select);
    if (executionLine() > 0) {
      workbench.showSource(executionLine(), 1);
    }
  }

  /** The call that is looked at. */
  public Optional<Scope> selected() {
    return held.selected();
  }

  /** Looks at a call; {@code depth} is 1 for the outermost. */
  public void select(int thread, int depth) {
    held.select(thread, depth)
        .ifPresent(
            scope -> {
              steps.follow(held.selected());
              variables.load(scope);
              watchTree.load(scope);
              showHeld();
              tellListeners();
            });
  }

  /**
   * The line of the program's text where the call that is looked at stands; 0 while nothing is
   * paused, and for lines of interpreter mode and of programs that are not open.
   */
  public int executionLine() {
    return held.line();
  }

  /** How the program is paused and continues. */
  public Stepping steps() {
    return steps;
  }

  /** Breakpoints of the open programs. */
  public OpenBreakpoints breakpoints() {
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

  /** Tells {@code listener} when a program was paused, continued, or another call is looked at. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tellListeners() {
    listeners.forEach(Runnable::run);
  }
}
