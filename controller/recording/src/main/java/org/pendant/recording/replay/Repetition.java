package org.pendant.recording.replay;

import java.util.Locale;
import java.util.OptionalLong;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;
import org.pendant.script.vm.ProgramEvent;

/**
 * Repetition: a controller that repeats another one's run, command by command, and can stand at any
 * frame on its way. It is compared with the other one before each command, and reaches nothing
 * outside before {@link #connect}. One thread at a time leads it.
 */
public final class Repetition {
  private final Journal original;
  private final Controller fresh;
  private final AtomicReference<Connectors> outside;

  /** The first command that it has not got yet. */
  private int next;

  private long turn;
  private OptionalLong startedFrame = OptionalLong.empty();

  private Repetition(Journal original, Controller fresh, AtomicReference<Connectors> outside) {
    this.original = original;
    this.fresh = fresh;
    this.outside = outside;
  }

  /**
   * One that stands where a controller does that was just switched on.
   *
   * @param options those of the run that is repeated
   */
  static Repetition begin(Journal original, ControllerOptions options) {
    AtomicReference<Connectors> outside = new AtomicReference<>(Connectors.NONE);
    ControllerOptions own = options.withOutside(Connectors.by(outside::get));
    return new Repetition(original, new Controller(own, original.controller().builtins()), outside);
  }

  /** As {@link #begin}, with a controller that was made with these options. */
  static Repetition with(Journal original, Controller fresh) {
    long frame = fresh.state().frame();
    if (frame != 0) {
      throw new IllegalArgumentException(
          "the controller is in frame " + frame + ", must not have run yet");
    }
    return new Repetition(original, fresh, new AtomicReference<>(Connectors.NONE));
  }

  /** The controller. */
  public Controller controller() {
    return fresh;
  }

  /** The frame that it stands in; any thread. */
  public long frame() {
    return fresh.state().frame();
  }

  /** The frame in which a program was started last; empty if none was. */
  public OptionalLong startedFrame() {
    return startedFrame;
  }

  /** Has it reach other computers by {@code connectors} from now on. */
  public void connect(Connectors connectors) {
    outside.set(connectors);
  }

  /**
   * Has it go on as a run of its own.
   *
   * @return its commands so far, and those to come
   */
  Journal goOn() {
    return Journal.continuing(original, next, fresh);
  }

  /**
   * Leads it on to the end of a frame, or up to where a debugger pauses that.
   *
   * @param frame not before the one that it stands in
   * @param commands of the other run that are known; all of those up to that frame
   * @param each sees every snapshot on the way
   * @throws RerunRefused if it came out otherwise
   * @throws CancellationException as soon as {@code cancelled} says so; it can be led on after that
   */
  void lead(long frame, int commands, Consumer<ControllerState> each, BooleanSupplier cancelled)
      throws RerunRefused {
    while (!arrived(frame, commands)) {
      if (cancelled.getAsBoolean()) {
        throw new CancellationException("the rerun was cancelled");
      }
      ControllerState before = fresh.state();
      boolean begins = !before.debug().held() && !isIn(before.frame(), commands);
      turn = begins ? 0 : turn + 1;
      long step = before.frame() + (begins ? 1 : 0);
      submit(step, commands);
      if (begins) {
        fresh.advance();
      } else {
        fresh.applyCommands();
      }
      see(fresh.state());
      each.accept(fresh.state());
      if (!fresh.state().debug().held() && isIn(step, commands) && original.entry(next).held()) {
        throw otherwise(step, "the debugger did not pause the program");
      }
    }
  }

  private void see(ControllerState state) {
    for (ProgramEvent event : state.newProgramEvents()) {
      if (event instanceof ProgramEvent.Started) {
        startedFrame = OptionalLong.of(state.frame());
      }
    }
  }

  private boolean arrived(long frame, int commands) throws RerunRefused {
    ControllerState state = fresh.state();
    if (isIn(state.frame(), commands)) {
      return false;
    }
    if (!state.debug().held()) {
      return state.frame() == frame;
    }
    if (state.frame() < frame) {
      throw otherwise(state.frame(), "the debugger paused the program");
    }
    return true;
  }

  /** Whether the next command belongs to a frame. */
  private boolean isIn(long wanted, int commands) {
    return next < commands && original.entry(next).frame() == wanted;
  }

  /** Leaves the commands of the next step. */
  private void submit(long begun, int commands) throws RerunRefused {
    while (isIn(begun, commands) && original.entry(next).turn() == turn) {
      Journal.Entry entry = original.entry(next);
      if (entry.before() != Fingerprint.of(fresh.state())) {
        throw otherwise(begun - 1, "arm, signals or program were not as before");
      }
      if (fresh.submit(entry.command()).isDone()) {
        // never so for as many as come into force in a frame, but a debugger may be asked for more
        throw otherwise(begun, "a frame got more commands than it takes");
      }
      next++;
    }
  }

  static RerunRefused otherwise(long frame, String what) {
    return new RerunRefused(
        String.format(
            Locale.ROOT,
            "the run came out otherwise at %.3f s: %s",
            frame * FrameTime.FRAME_S,
            what));
  }
}
