package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.Optional;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Host;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.ProgramControl;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.value.ScriptError;

/**
 * Companion program: runs beside the primary one, frame by frame after it, whether or not that
 * runs; a test that watches a program is one. It has threads and may wait, but nothing that belongs
 * to the primary program: no pause, no interpreter mode. What it must not call is left to whoever
 * starts it. Owned by the frame loop, as its {@link Machine} is.
 */
public final class Companion {
  private final Builtins<?> builtins;
  private final Host host;
  private final Translation translation;
  private final RunLimits limits;
  private Optional<ProgramRun> run = Optional.empty();
  private Optional<Ending> ending = Optional.empty();
  private boolean advancing;

  Companion(Builtins<?> builtins, Host host, Translation translation, long memoryBytes) {
    this.builtins = builtins;
    this.host = host;
    this.translation = translation;
    limits = new RunLimits(Slices.PRIMARY, memoryBytes);
  }

  /**
   * Starts a program in place of any before; it runs from the next {@link #advance} on.
   *
   * @throws IllegalStateException while another one runs
   */
  public void start(Program program) {
    if (running()) {
      throw new IllegalStateException("companion " + run.get().program().name() + " still runs");
    }
    ending = Optional.empty();
    run =
        Optional.of(
            new ProgramRun(
                program,
                builtins,
                host,
                new Control(),
                thread -> false,
                translation,
                DebugHook.NONE,
                limits));
  }

  /** Whether one was started and has not ended. */
  public boolean running() {
    return run.isPresent() && ending.isEmpty();
  }

  /** Runs its threads for one frame; nothing where none is or it has ended. */
  public void advance() {
    if (!running()) {
      return;
    }
    ProgramRun running = run.get();
    advancing = true;
    try {
      switch (running.advance()) {
        case RUNNING, HELD, PAUSED -> {}
        case HALTED -> end(new Ending.Halted());
        case FINISHED -> end(new Ending.Finished());
      }
    } catch (ThreadFailure thrown) {
      end(new Ending.Failed(ProgramFailure.of(thrown.thread(), thrown.error())));
    } finally {
      advancing = false;
    }
    running.takeFault().ifPresent(host::internalError);
  }

  private void end(Ending how) {
    run.orElseThrow().endAll();
    ending = Optional.of(how);
  }

  /** Ends it from outside; no effect where none runs. */
  public void stop() {
    if (running()) {
      end(new Ending.Stopped());
    }
  }

  /** How it ended; empty while it runs, and before the first. */
  public Optional<Ending> ending() {
    return ending;
  }

  /** What it has reached so far; empty before the first, and of one without coverage. */
  public Optional<Coverage> coverage() {
    return run.flatMap(ProgramRun::coverage);
  }

  /** What it is at while it runs its part of a frame; empty at any other time. */
  Optional<ScriptPlace> place() {
    return advancing ? run.map(ProgramRun::place) : Optional.empty();
  }

  /** What builtins may do to a companion: end it. */
  private final class Control implements ProgramControl {
    @Override
    public long frame() {
      return run.orElseThrow().frame();
    }

    @Override
    public void pause() {
      // the primary program is what people pause; this one continues
    }

    @Override
    public void halt() {
      run.orElseThrow().requestHalt();
    }

    @Override
    public Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd)
        throws ScriptError {
      throw refused("interpreter_mode");
    }

    @Override
    public void endInterpreter() {}

    @Override
    public void clearInterpreter() throws ScriptError {
      throw refused("clear_interpreter");
    }

    private static ScriptError refused(String function) {
      return new ScriptError("not-beside", text("onlyProgramInterprets", function));
    }
  }
}
