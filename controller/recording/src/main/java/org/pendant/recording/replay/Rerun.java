package org.pendant.recording.replay;

import static org.pendant.recording.replay.ReplayTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.pendant.controller.Controller;
import org.pendant.controller.box.Determinism;
import org.pendant.controller.state.ControllerState;

/**
 * Rerun: brings controllers to the end of a frame of the run of others, as fast as the processor
 * allows, and compares the two at every command and in the end: fresh ones, or some that have gone
 * a part of the way ({@link ParkedRuns}). The others are not touched and may continue.
 *
 * <p>A frame that a debugger still pauses is repeated up to where it is paused. The end of a frame
 * after which robot time stood is with the commands that came into force meanwhile.
 *
 * <p>One thread runs it, once; any thread may ask how far it is, or cancel it.
 */
public final class Rerun {
  private final RunJournal journal;
  private final int commands;
  private final long frame;
  private final List<Optional<ControllerState>> recorded;
  private volatile long reached;
  private volatile boolean cancelled;

  private Rerun(RunJournal journal, long frame, List<Optional<ControllerState>> recorded)
      throws RerunRefused {
    // Asked before the commands are counted: those of all frames up to this one are there then.
    Optional<String> refusal = journal.refusal(frame);
    if (refusal.isPresent()) {
      throw new RerunRefused(refusal.get());
    }
    this.journal = journal;
    this.frame = frame;
    this.recorded = List.copyOf(recorded);
    commands = journal.size();
  }

  /**
   * A rerun up to the end of a frame, or up to where that is paused.
   *
   * @param frame 0 for controllers that were just switched on
   * @throws RerunRefused if there is no such frame, or it cannot be repeated
   */
  public static Rerun to(long frame, RunJournal journal) throws RerunRefused {
    return new Rerun(journal, frame, List.of());
  }

  /**
   * As {@link #to(long, RunJournal)}, and the new run must end as the old one was then.
   *
   * @param recorded a snapshot of each controller of the old run at the end of the frame, in their
   *     order; empty where nothing is recorded
   */
  public static Rerun to(long frame, RunJournal journal, List<Optional<ControllerState>> recorded)
      throws RerunRefused {
    if (recorded.size() != journal.controllers().all().size()) {
      throw new IllegalArgumentException(
          "there are "
              + recorded.size()
              + " snapshots, must be "
              + journal.controllers().all().size());
    }
    return new Rerun(journal, frame, recorded);
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
   * Runs controllers that were just switched on as those of the run that is repeated; only their
   * ways to the outside may be others. The calling thread drives them; when this returns, nobody
   * does.
   *
   * @param each runs after each step, as for a reader who saw every snapshot of the old run
   * @return the commands of the new controllers, and with them the controllers
   * @throws RerunRefused if the new run came out otherwise than the old one
   * @throws CancellationException after {@link #cancel}
   */
  public RunJournal run(Controllers fresh, Runnable each) throws RerunRefused {
    return run(Repetition.with(journal, fresh), each);
  }

  /**
   * As {@link #run(Controllers, Runnable)}, by leading on what has repeated a part of the way
   * already.
   *
   * @param part of this run, and not beyond the frame; it goes on as a run of its own
   */
  public RunJournal run(Repetition part) throws RerunRefused {
    return run(part, () -> {});
  }

  private RunJournal run(Repetition part, Runnable each) throws RerunRefused {
    reached = part.frame();
    part.lead(
        frame,
        commands,
        () -> {
          reached = part.frame();
          each.run();
        },
        () -> cancelled);
    for (int i = 0; i < part.controllers().all().size(); i++) {
      refuseUnlessSame(part.controllers(), i);
    }
    return part.goOn();
  }

  private void refuseUnlessSame(Controllers all, int member) throws RerunRefused {
    Controller fresh = all.all().get(member);
    List<Determinism.FileRead> was = files(journal.controllers().all().get(member));
    List<Determinism.FileRead> is = files(fresh);
    for (int i = 0; i < Math.min(was.size(), is.size()); i++) {
      if (!was.get(i).equals(is.get(i))) {
        throw Repetition.otherwise(
            was.get(i).frame(), all.told(member, text("fileChanged", was.get(i).file())));
      }
    }
    if (was.size() != is.size()) {
      throw Repetition.otherwise(frame, all.told(member, text("filesRead", is.size(), was.size())));
    }
    Optional<Determinism.Loss> loss = fresh.determinism().loss();
    if (loss.isPresent()) {
      throw Repetition.otherwise(loss.get().frame(), all.told(member, loss.get().reason()));
    }
    Optional<String> difference =
        comparable(all, member).flatMap(state -> StateDifference.between(state, fresh.state()));
    if (difference.isPresent()) {
      throw Repetition.otherwise(frame, all.told(member, difference.get()));
    }
  }

  /** What a controller was at the same moment; empty in the middle of a frame that went on. */
  private Optional<ControllerState> comparable(Controllers all, int member) {
    if (recorded.isEmpty()) {
      return Optional.empty();
    }
    boolean held = all.all().get(member).held();
    return all.frames().held() == held
        ? recorded.get(member).filter(state -> state.debug().held() == held)
        : Optional.empty();
  }

  private List<Determinism.FileRead> files(Controller controller) {
    return controller.determinism().files().stream().filter(each -> each.frame() <= frame).toList();
  }
}
