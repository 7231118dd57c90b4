package org.pendant.desktop.timeline;

import java.awt.EventQueue;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.kit.fault.Faults;
import org.pendant.recording.Recording;

/**
 * Track watch: lets tracks be looked for beside the dispatch thread, one at a time and at most half
 * of the time.
 */
final class TrackWatch {
  /** So long nothing new is looked at while only time goes by. */
  private static final long REST_NS = 400_000_000;

  private final Consumer<Tracks> found;
  private boolean busy;
  private long doneNs = System.nanoTime() - REST_NS;
  private long restNs;
  private TimeRange last = Tracks.NONE.range();

  /** Hands what was found to {@code found}, on the dispatch thread. */
  TrackWatch(Consumer<Tracks> found) {
    this.found = found;
  }

  /**
   * Looks, unless that would be too often.
   *
   * @param startRamp whether the programs of the recording have a start ramp
   * @param cell whether there is something around the arm
   */
  void look(Recording recording, TimeRange range, int buckets, boolean startRamp, boolean cell) {
    // Another width is another picture; one that only moves with time can wait.
    boolean other = Math.abs(range.widthS() - last.widthS()) > 1e-9;
    long since = System.nanoTime() - doneNs;
    if (busy || buckets < 1 || since < (other ? restNs : Math.max(REST_NS, restNs))) {
      return;
    }
    busy = true;
    last = range;
    long begin = System.nanoTime();
    Thread.ofVirtual()
        .name("timeline")
        .start(
            () -> {
              Optional<Tracks> tracks = tracks(recording, range, buckets, startRamp, cell);
              EventQueue.invokeLater(() -> done(tracks, System.nanoTime() - begin));
            });
  }

  /** Empty after a fault of ours: what was found before stays. */
  private static Optional<Tracks> tracks(
      Recording recording, TimeRange range, int buckets, boolean startRamp, boolean cell) {
    try {
      return Optional.of(Tracks.of(recording, range, buckets, startRamp, cell));
    } catch (UncheckedIOException e) {
      // A file has gone. A user who looks at a moment of it is told; here nothing is drawn.
      return Optional.of(Tracks.NONE);
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return Optional.empty();
    }
  }

  private void done(Optional<Tracks> tracks, long tookNs) {
    busy = false;
    doneNs = System.nanoTime();
    restNs = tookNs;
    tracks.ifPresent(found);
  }
}
