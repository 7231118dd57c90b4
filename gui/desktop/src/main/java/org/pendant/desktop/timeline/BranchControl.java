package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.Branching;
import org.pendant.desktop.session.Branching.Outcome;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.replay.RerunRefused;

/**
 * Branch control: continues from a moment of the past. It asks first, since the run after that
 * moment is dropped. Only for the dispatch thread.
 */
final class BranchControl {
  private final LookBack lookBack;
  private final Branches branches;
  private final Executor dispatch;
  private final Consumer<String> tell;
  private final Runnable changed;
  private Optional<ControllerState> asking = Optional.empty();
  private Optional<Branching> running = Optional.empty();

  /** What the session can do. */
  interface Branches {
    /** Why there can be no branch from a frame; empty if there can. */
    Optional<String> refusal(long frame);

    /** Begins to branch. */
    Branching begin(ControllerState recorded) throws RerunRefused;
  }

  /**
   * Nothing is asked yet.
   *
   * @param dispatch runs what comes later in the thread that uses this object
   * @param changed runs after each change of what there is to show
   */
  BranchControl(
      LookBack lookBack,
      Branches branches,
      Executor dispatch,
      Consumer<String> tell,
      Runnable changed) {
    this.lookBack = lookBack;
    this.branches = branches;
    this.dispatch = dispatch;
    this.tell = tell;
    this.changed = changed;
    lookBack.addListener(this::forget);
  }

  /** Who has gone back to now has left the question behind. */
  private void forget() {
    if (asking.isPresent() && !lookBack.back()) {
      asking = Optional.empty();
      changed.run();
    }
  }

  /** Why there is nothing to branch from now; empty if there is. */
  String whyNot() {
    if (running.isPresent()) {
      return text("aBranchIsOnItsWay");
    }
    String why = lookBack.whyNoBranch();
    return why.isEmpty()
        ? lookBack
            .branchStart()
            .flatMap(state -> branches.refusal(state.frame()))
            .map(reason -> text("noBranchFromHere", reason))
            .orElse("")
        : why;
  }

  /** Asks whether to branch from the moment that people look at, or tells why it cannot be. */
  void ask() {
    String why = whyNot();
    if (why.isEmpty()) {
      asking = lookBack.branchStart();
      changed.run();
    } else {
      tell.accept(why);
    }
  }

  /** The question that waits for an answer, short enough for a low dock; empty for none. */
  Optional<String> question() {
    return asking.map(
        state -> text("continueFromTimePausedWhatCame", LookBack.text(state.timeS())));
  }

  /** What the branch that is on its way does, 0 to 1; empty while there is none. */
  Optional<Double> progress() {
    return running.map(Branching::progress);
  }

  /** The question is answered with yes. */
  void confirm() {
    ControllerState from = asking.orElseThrow();
    asking = Optional.empty();
    try {
      Branching begun = branches.begin(from);
      running = Optional.of(begun);
      var _ =
          begun
              .outcome()
              .whenCompleteAsync(
                  (outcome, fault) -> done(begun, Optional.ofNullable(outcome), fault), dispatch);
    } catch (RerunRefused e) {
      tell.accept(text("noBranch", e.getMessage()));
    }
    changed.run();
  }

  /** The question is answered with no, or what is on its way is ended. */
  void cancel() {
    asking = Optional.empty();
    running.ifPresent(Branching::cancel);
    changed.run();
  }

  private void done(Branching begun, Optional<Outcome> outcome, Throwable fault) {
    if (running.equals(Optional.of(begun))) {
      running = Optional.empty();
    }
    if (outcome.isEmpty()) {
      tell.accept(text("noBranchAnInternalError", fault));
    } else {
      switch (outcome.get()) {
        case Outcome.Branched branched -> {
          lookBack.live();
          tell.accept(
              text(
                  "theRobotIsAtAgainAnd",
                  LookBack.text(begun.frame() / (double) FrameTime.FRAMES_PER_SECOND)));
        }
        case Outcome.Refused refused -> tell.accept(text("noBranch", refused.reason()));
        case Outcome.Cancelled cancelled -> tell.accept(text("theBranchWasCancelled"));
      }
    }
    changed.run();
  }
}
