package org.pendant.recording.replay;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.Determinism;
import org.pendant.controller.state.ControllerState;

/**
 * Rerun: brings a controller to the end of a frame of another one's run, as fast as the processor
 * allows, and compares the two at every command and in the end: a fresh one, or one that has gone a
 * part of the way ({@link ParkedRuns}). The other controller is not touched and may continue.
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
    return run(Repetition.with(journal, fresh), each);
  }

  /**
   * As {@link #run(ControllerOptions)}, by leading on what has repeated a part of the way already.
   *
   * @param part of this run, and not beyond the frame; it goes on as a run of its own
   */
  public Journal run(Repetition part) throws RerunRefused {
    return run(part, state -> {});
  }

  private Journal run(Repetition part, Consumer<ControllerState> each) throws RerunRefused {
    reached = part.frame();
    part.lead(
        frame,
        commands,
        state -> {
          reached = state.frame();
          each.accept(state);
        },
        () -> cancelled);
    refuseUnlessSame(part.controller());
    return part.goOn();
  }

  private void refuseUnlessSame(Controller fresh) throws RerunRefused {
    List<Determinism.FileRead> was = files(journal.controller());
    List<Determinism.FileRead> is = files(fresh);
    for (int i = 0; i < Math.min(was.size(), is.size()); i++) {
      if (!was.get(i).equals(is.get(i))) {
        throw Repetition.otherwise(
            was.get(i).frame(), "the file " + was.get(i).file() + " has changed");
      }
    }
    if (was.size() != is.size()) {
      throw Repetition.otherwise(
          frame, "programs read " + is.size() + " files, before " + was.size());
    }
    Optional<Determinism.Loss> loss = fresh.determinism().loss();
    if (loss.isPresent()) {
      throw Repetition.otherwise(loss.get().frame(), loss.get().reason());
    }
    boolean sameMoment =
        recorded.isPresent() && recorded.get().debug().held() == fresh.state().debug().held();
    Optional<String> difference =
        sameMoment ? StateDifference.between(recorded.get(), fresh.state()) : Optional.empty();
    if (difference.isPresent()) {
      throw Repetition.otherwise(frame, difference.get());
    }
  }

  private List<Determinism.FileRead> files(Controller controller) {
    return controller.determinism().files().stream().filter(each -> each.frame() <= frame).toList();
  }
}
