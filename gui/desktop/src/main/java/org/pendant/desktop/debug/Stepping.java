package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ProgramControls;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.value.ScriptError;

/**
 * Stepping: how a program is paused and continues: steps belong to the thread that is looked at. It
 * has no Swing; one thread uses it, the dispatch thread.
 */
public final class Stepping {
  private final DebugLink link;
  private final IntFunction<List<Integer>> toRun;
  private final Consumer<String> tell;
  private DebugState debug = DebugState.FREE;
  private boolean running;

  /** The program is paused, not by the debugger, and could be resumed. */
  private boolean resumable;

  private int thread = Debugger.MAIN;
  private BooleanSupplier past = () -> false;
  private Runnable pastStep = () -> {};

  /**
   * Nothing runs yet.
   *
   * @param toRun the lines of the running text that a line of the present one was
   * @param tell says why something was refused
   */
  Stepping(DebugLink link, IntFunction<List<Integer>> toRun, Consumer<String> tell) {
    this.link = link;
    this.toRun = toRun;
    this.tell = tell;
  }

  /** Takes the newest snapshot. */
  void refresh(ControllerState state) {
    debug = state.debug();
    running = ProgramPhase.of(state) == ProgramPhase.RUNNING;
    resumable = !debug.held() && ProgramControls.of(state).canResume();
  }

  /** Has the next steps be those of the thread of {@code scope}; the main thread without one. */
  void follow(Optional<Scope> scope) {
    thread = scope.map(Scope::thread).orElse(Debugger.MAIN);
  }

  /**
   * Has steps into and over calls be through a recording while people look at the past.
   *
   * @param looking whether they do
   * @param step to the next statement there
   */
  public void inThePast(BooleanSupplier looking, Runnable step) {
    past = looking;
    pastStep = step;
  }

  /** Whether a paused program can continue by steps; one that has failed can only end. */
  public boolean canStep() {
    return resumable || canKill();
  }

  /** Whether threads of the program can be ended: the debugger has paused it. */
  public boolean canKill() {
    return debug.stop().filter(stop -> !(stop.reason() instanceof PauseReason.Failed)).isPresent();
  }

  /** Whether there is a program to hold. */
  public boolean canPause() {
    return running;
  }

  /** Holds all threads of the program before their next statements. */
  public void pause() {
    send(Debugger::pause);
  }

  /** To the next statement of the thread, in any function. */
  public void into() {
    if (past.getAsBoolean()) {
      pastStep.run();
      return;
    }
    int stepped = thread;
    step(debugger -> debugger.stepInto(stepped));
  }

  /** To the next statement of the same function. */
  public void over() {
    if (past.getAsBoolean()) {
      pastStep.run();
      return;
    }
    int stepped = thread;
    step(debugger -> debugger.stepOver(stepped));
  }

  /** To the next statement of the caller. */
  public void out() {
    int stepped = thread;
    step(debugger -> debugger.stepOut(stepped));
  }

  /** To a line of the program's text, from 1. */
  public void runTo(int line) {
    int stepped = thread;
    List<Integer> wanted = toRun.apply(line);
    if (wanted.isEmpty()) {
      tell.accept(text("lineIsNotInThePart", line));
      return;
    }
    int next =
        wanted.stream().filter(each -> each > heldLine()).findFirst().orElse(wanted.getLast());
    step(debugger -> debugger.runTo(stepped, next));
  }

  private int heldLine() {
    return debug.stop().map(DebugState.Stop::line).orElse(0);
  }

  /** Ends a thread of a paused program, and those that it started. */
  public void kill(int killed) {
    send(debugger -> debugger.kill(killed));
  }

  /** Something that the debugger has to do. */
  @FunctionalInterface
  private interface Deed {
    void on(Debugger debugger) throws ScriptError;
  }

  /**
   * A program that the debugger has not paused itself is resumed and held where it stands first.
   */
  private void step(Deed deed) {
    if (!resumable) {
      send(deed);
      return;
    }
    link.resume(this::refused);
    send(
        debugger -> {
          debugger.pause();
          deed.on(debugger);
        });
  }

  private void send(Deed deed) {
    link.ask(
        debugger -> {
          deed.on(debugger);
          return true;
        },
        done -> {},
        this::refused);
  }

  private void refused(String why) {
    tell.accept(text("refused", why));
  }
}
