package org.pendant.recording.replay;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.Determinism;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;

/**
 * Rerun: brings a fresh controller to the end of a frame of another one's run, as fast as the
 * processor allows, and compares the two at every command and in the end. The other controller is
 * not touched and may continue meanwhile.
 *
 * <p>A frame that a debugger still pauses is repeated up to where it is paused. The end of a frame
 * after which robot time stood is with the commands that came into force meanwhile.
 *
 * <p>One thread runs it, once; any thread may ask how far it is, or cancel it.
 */
public final class Rerun {
  private final Journal journal;
  private final int commands;
  private final long frame;
  private final Optional<ControllerState> recorded;
  private volatile long reached;
  private volatile boolean cancelled;

  private Rerun(Journal journal, long frame, Optional<ControllerState> recorded)
      throws RerunRefused {
    // Asked before the commands are counted: those of all frames up to this one are there then.
    Optional<String> refusal = journal.refusal(frame);
    if (refusal.isPresent()) {
      throw new RerunRefused(refusal.get());
    }
    this.journal = journal;
    this.frame = frame;
    this.recorded = recorded;
    commands = journal.size();
  }

  /**
   * A rerun up to the end of a frame, or up to where that is paused.
   *
   * @param frame 0 for a controller that was just switched on
   * @throws RerunRefused if there is no such frame, or it cannot be repeated
   */
  public static Rerun to(long frame, Journal journal) throws RerunRefused {
    return new Rerun(journal, frame, Optional.empty());
  }

  /**
   * As {@link #to(long, Journal)}, and the new run must end as the old one was then.
   *
   * @param recorded a snapshot of the old run
   */
  public static Rerun to(ControllerState recorded, Journal journal) throws RerunRefused {
    return new Rerun(journal, recorded.frame(), Optional.of(recorded));
  }

  /** The frame that it leads to. */
  public long frame() {
    return frame;
  }

  /** How much of the way is done, 0 to 1. */
  public double progress() {
    return frame == 0 ? 1 : (double) reached / frame;
  }

  /** Has {@link #run} end as soon as possible. */
  public void cancel() {
    cancelled = true;
  }

  /**
   * Runs a controller that it switches on.
   *
   * @param options those of the run that is repeated
   * @return the commands of the new controller, and with them the controller
   * @throws RerunRefused if the new run came out otherwise than the old one
   * @throws CancellationException after {@link #cancel}
   */
  public Journal run(ControllerOptions options) throws RerunRefused {
    return run(new Controller(options, journal.controller().builtins()), state -> {});
  }

  /**
   * As {@link #run(ControllerOptions)}, with a controller that was just switched on with the same
   * options; only its ways to the outside may be others. The calling thread drives it; when this
   * returns, nobody does.
   *
   * @param each sees every snapshot, as a reader did who saw those of the old controller
   */
  public Journal run(Controller fresh, Consumer<ControllerState> each) throws RerunRefused {
    Journal copy = Journal.of(fresh, journal.limits());
    int next = 0;
    long turn = 0;
    while (!arrived(fresh.state(), next)) {
      if (cancelled) {
        throw new CancellationException("the rerun was cancelled");
      }
      ControllerState before = fresh.state();
      boolean begins = !before.debug().held() && !isIn(before.frame(), next);
      turn = begins ? 0 : turn + 1;
      long step = before.frame() + (begins ? 1 : 0);
      next = submit(fresh, next, step, turn);
      if (begins) {
        fresh.advance();
      } else {
        fresh.applyCommands();
      }
      reached = fresh.state().frame();
      each.accept(fresh.state());
      if (!fresh.state().debug().held() && isIn(step, next) && journal.entry(next).held()) {
        throw otherwise(step, "the debugger did not pause the program");
      }
    }
    refuseUnlessSame(fresh);
    return copy;
  }

  private boolean arrived(ControllerState state, int next) throws RerunRefused {
    if (isIn(state.frame(), next)) {
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

  /** Whether command {@code next} belongs to a frame. */
  private boolean isIn(long wanted, int next) {
    return next < commands && journal.entry(next).frame() == wanted;
  }

  /** Leaves the commands of the next step; answers which command is the first after them. */
  private int submit(Controller fresh, int first, long begun, long turn) throws RerunRefused {
    int next = first;
    while (isIn(begun, next) && journal.entry(next).turn() == turn) {
      Journal.Entry entry = journal.entry(next);
      if (entry.before() != Fingerprint.of(fresh.state())) {
        throw otherwise(begun - 1, "arm, signals or program were not as before");
      }
      if (fresh.submit(entry.command()).isDone()) {
        // never so for as many as come into force in a frame, but a debugger may be asked for more
        throw otherwise(begun, "a frame got more commands than it takes");
      }
      next++;
    }
    return next;
  }

  private void refuseUnlessSame(Controller fresh) throws RerunRefused {
    List<Determinism.FileRead> was = files(journal.controller());
    List<Determinism.FileRead> is = files(fresh);
    for (int i = 0; i < Math.min(was.size(), is.size()); i++) {
      if (!was.get(i).equals(is.get(i))) {
        throw otherwise(was.get(i).frame(), "the file " + was.get(i).file() + " has changed");
      }
    }
    if (was.size() != is.size()) {
      throw otherwise(frame, "programs read " + is.size() + " files, before " + was.size());
    }
    Optional<Determinism.Loss> loss = fresh.determinism().loss();
    if (loss.isPresent()) {
      throw otherwise(loss.get().frame(), loss.get().reason());
    }
    boolean sameMoment =
        recorded.isPresent() && recorded.get().debug().held() == fresh.state().debug().held();
    Optional<String> difference =
        sameMoment ? StateDifference.between(recorded.get(), fresh.state()) : Optional.empty();
    if (difference.isPresent()) {
      throw otherwise(frame, difference.get());
    }
  }

  private List<Determinism.FileRead> files(Controller controller) {
    return controller.determinism().files().stream().filter(each -> each.frame() <= frame).toList();
  }

  private static RerunRefused otherwise(long frame, String what) {
    return new RerunRefused(
        String.format(
            Locale.ROOT,
            "the run came out otherwise at %.3f s: %s",
            frame * FrameTime.FRAME_S,
            what));
  }
}
