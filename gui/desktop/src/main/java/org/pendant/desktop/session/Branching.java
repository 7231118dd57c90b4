package org.pendant.desktop.session;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import org.pendant.recording.replay.Rerun;
import org.pendant.recording.replay.RerunRefused;

/**
 * Branching: a branch that is being made: beside the controller that continues, another one repeats
 * its run up to a frame and takes its place then. Any thread may ask how far it is, or cancel it.
 */
public final class Branching {
  private final Rerun rerun;
  private final CompletableFuture<Outcome> outcome = new CompletableFuture<>();

  /** What became of it. */
  public sealed interface Outcome {
    /** The session works with the new controller now, and robot time is paused. */
    record Branched(long frame) implements Outcome {}

    /** Nothing has changed; the reason is for people. */
    record Refused(String reason) implements Outcome {}

    /** Nothing has changed, as the user wished. */
    record Cancelled() implements Outcome {}
  }

  /** Makes the new controller and puts it in the place of the old. */
  @FunctionalInterface
  interface Work {
    void run() throws RerunRefused;
  }

  private Branching(Rerun rerun) {
    this.rerun = rerun;
  }

  /** Begins, in a thread of its own. */
  static Branching begin(Rerun rerun, Work work) {
    Branching branching = new Branching(rerun);
    Thread.ofPlatform().daemon().name("branch").start(() -> branching.run(work));
    return branching;
  }

  private void run(Work work) {
    try {
      work.run();
      outcome.complete(new Outcome.Branched(rerun.frame()));
    } catch (RerunRefused e) {
      outcome.complete(new Outcome.Refused(e.getMessage()));
    } catch (CancellationException e) {
      outcome.complete(new Outcome.Cancelled());
    } catch (RuntimeException | Error e) {
      outcome.completeExceptionally(e);
    }
  }

  /** The frame from which it branches. */
  public long frame() {
    return rerun.frame();
  }

  /** How much of the way is done, 0 to 1. */
  public double progress() {
    return rerun.progress();
  }

  /** Ends it as soon as possible; too late once the new controller is there. */
  public void cancel() {
    rerun.cancel();
  }

  /** What became of it; fails with a fault of ours. */
  public CompletableFuture<Outcome> outcome() {
    return outcome.copy();
  }
}
