package org.pendant.desktop.debug;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.ProgramState;

/**
 * Stepping: how a program is paused and continues: steps belong to the thread that is looked at. It
 * has no Swing; one thread uses it, the dispatch thread.
 */
public final class Stepping {
  private final DebugLink link;
  private final IntFunction<List<Integer>> toRun;
  private final Consumer<String> tell;
  private DebugState debug = DebugState.FREE;
  private ProgramState program = ProgramState.STOPPED;
  private int thread = Debugger.MAIN;

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
  void refresh(DebugState debug, ProgramState program) {
    this.debug = debug;
    this.program = program;
  }

  /** Has the next steps be those of the thread of {@code scope}; the main thread without one. */
  void follow(Optional<Scope> scope) {
    thread = scope.map(Scope::thread).orElse(Debugger.MAIN);
  }

  /** Whether a paused program can continue by steps; one that has failed can only end. */
  public boolean canStep() {
    return debug.stop().filter(stop -> !(stop.reason() instanceof PauseReason.Failed)).isPresent();
  }

  /** Whether there is a program to hold. */
  public boolean canPause() {
    return program == ProgramState.RUNNING && !debug.held();
  }

  /** Lets the program continue; one that has failed ends. */
  public void resume() {
    send(Debugger::resume);
  }

  /** Holds all threads of the program before their next statements. */
  public void pause() {
    send(Debugger::pause);
  }

  /** To the next statement of the thread, in any function. */
  public void into() {
    int stepped = thread;
    send(debugger -> debugger.stepInto(stepped));
  }

  /** To the next statement of the same function. */
  public void over() {
    int stepped = thread;
    send(debugger -> debugger.stepOver(stepped));
  }

  /** To the next statement of the caller. */
  public void out() {
    int stepped = thread;
    send(debugger -> debugger.stepOut(stepped));
  }

  /** To a line of the program's text, from 1. */
  public void runTo(int line) {
    int stepped = thread;
    List<Integer> wanted = toRun.apply(line);
    if (wanted.isEmpty()) {
      tell.accept("Line " + line + " is not in the part of the program that runs");
      return;
    }
    int next =
        wanted.stream().filter(each -> each > heldLine()).findFirst().orElse(wanted.getLast());
    send(debugger -> debugger.runTo(stepped, next));
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

  private void send(Deed deed) {
    link.ask(
        debugger -> {
          deed.on(debugger);
          return true;
        },
        done -> {},
        why -> tell.accept("Refused: " + why));
  }
}
