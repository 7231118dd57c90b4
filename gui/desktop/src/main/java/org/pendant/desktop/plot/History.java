package org.pendant.desktop.plot;

import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Recording;

/**
 * Chart history: ten minutes of the quantities that are drawn: 125 samples a second, and of script
 * variables every frame. They are taken from the recording, which has them whether the charts are
 * shown or not. Much that is new or old is taken a piece at a time, so that nobody waits for it.
 * One thread uses it.
 */
final class History {
  /** Frames from one sample to the next: 125 a second. */
  static final int FRAMES_PER_SAMPLE = 4;

  /** Samples that are taken at once, which takes some milliseconds. */
  static final int PIECE = 1024;

  private static final int KEPT_S = 600;
  private static final int SAMPLES_PER_SECOND = FrameTime.FRAMES_PER_SECOND / FRAMES_PER_SAMPLE;

  private final Supplier<Recording> recorded;

  /** Sample {@code n} is that of frame {@code n * FRAMES_PER_SAMPLE}. */
  private final TimeSeries samples = new TimeSeries(KEPT_S * SAMPLES_PER_SECOND, 1);

  /** Sample {@code n} is that of frame {@code n}. */
  private final TimeSeries frames = new TimeSeries(KEPT_S * FrameTime.FRAMES_PER_SECOND, 1);

  /** One name for each script variable that is tracked, with its readings of the present frame. */
  private final Map<ChartQuantity, String> names = new HashMap<>();

  /** Quantities whose past is not all here yet, with the sample that they are known from. */
  private final Map<ChartQuantity, Long> knownFrom = new LinkedHashMap<>();

  private volatile boolean another;
  private boolean behind;

  /**
   * A history that begins with what is recorded.
   *
   * @param recorded gives what the controller did until now
   */
  History(Supplier<Recording> recorded) {
    this.recorded = recorded;
  }

  /** Another controller has been switched on, with a recording of its own; any thread. */
  void anotherController() {
    another = true;
  }

  /** Takes what is new in the recording, or a piece of it; returns whether there was anything. */
  boolean follow() {
    boolean exchanged = another;
    another = false;
    Recording recording = recorded.get();
    behind = false;
    if (exchanged || recording.lastFrame() < FRAMES_PER_SAMPLE * (samples.end() - 1)) {
      startAfresh();
    }
    try {
      boolean news = followSamples(recording);
      news |= followFrames(recording);
      return fillPast(recording) || news;
    } catch (UncheckedIOException e) {
      // its file has gone: a gap is left
      samples.startAt(recording.lastFrame() / FRAMES_PER_SAMPLE + 1);
      frames.startAt(recording.lastFrame() + 1);
      return true;
    }
  }

  /** Whether there was more than the piece that was taken last. */
  boolean behind() {
    return behind;
  }

  private void startAfresh() {
    samples.startAt(1);
    frames.startAt(1);
    knownFrom.clear();
  }

  private boolean followSamples(Recording recording) {
    long newest = recording.lastFrame() / FRAMES_PER_SAMPLE;
    long oldest =
        Math.max(
            Math.ceilDiv(recording.firstFrame(), FRAMES_PER_SAMPLE),
            newest + 1 - (long) KEPT_S * SAMPLES_PER_SECOND);
    if (oldest > samples.end()) {
      // more has gone by than is recorded: an honest gap is better than a line across it
      samples.startAt(oldest);
    }
    if (newest < samples.end()) {
      return false;
    }
    long last = Math.min(newest, samples.end() + PIECE - 1);
    behind |= last < newest;
    recording.everyNth(
        FRAMES_PER_SAMPLE,
        FRAMES_PER_SAMPLE * samples.end(),
        FRAMES_PER_SAMPLE * last,
        state -> samples.take(state.timeS(), quantity -> quantity.value().applyAsDouble(state)));
    return true;
  }

  private boolean followFrames(Recording recording) {
    long newest = recording.lastFrame();
    if (names.isEmpty()) {
      // they are not shown
      frames.startAt(newest + 1);
      return false;
    }
    if (recording.firstFrame() > frames.end()) {
      frames.startAt(recording.firstFrame());
    }
    if (newest < frames.end()) {
      return false;
    }
    long last = Math.min(newest, frames.end() + PIECE - 1);
    behind |= last < newest;
    recording.everyNth(
        1,
        frames.end(),
        last,
        state -> frames.take(state.timeS(), quantity -> state.traced().value(names.get(quantity))));
    return true;
  }

  /** Takes a piece of the past of those quantities of which the least is known. */
  private boolean fillPast(Recording recording) {
    if (knownFrom.isEmpty()) {
      return false;
    }
    long known = knownFrom.values().stream().mapToLong(Long::longValue).max().orElseThrow();
    List<ChartQuantity> late =
        knownFrom.keySet().stream().filter(each -> knownFrom.get(each) == known).toList();
    long oldest =
        Math.max(samples.first(), Math.ceilDiv(recording.firstFrame(), FRAMES_PER_SAMPLE));
    long from = Math.max(oldest, known - PIECE);
    fill(recording, late, from, known);
    for (ChartQuantity each : late) {
      if (from > oldest) {
        knownFrom.put(each, from);
      } else {
        knownFrom.remove(each);
      }
    }
    behind |= !knownFrom.isEmpty();
    return true;
  }

  private void fill(Recording recording, Collection<ChartQuantity> late, long from, long end) {
    recording.everyNth(
        FRAMES_PER_SAMPLE,
        FRAMES_PER_SAMPLE * from,
        FRAMES_PER_SAMPLE * (end - 1),
        state -> {
          long number = state.frame() / FRAMES_PER_SAMPLE;
          late.forEach(each -> samples.set(each, number, each.value().applyAsDouble(state)));
        });
  }

  /** The samples that a tracked quantity is in. */
  TimeSeries of(ChartQuantity quantity) {
    return quantity.variable() ? frames : samples;
  }

  /** Keeps a quantity from now on, and what the recording has of it, which comes piece by piece. */
  void track(ChartQuantity quantity) {
    TimeSeries series = of(quantity);
    if (series.has(quantity)) {
      return;
    }
    series.add(quantity);
    if (quantity.variable()) {
      // the controller had not been asked for it
      names.put(quantity, quantity.id().substring(ScriptVariables.PREFIX.length()));
    } else if (!samples.empty()) {
      knownFrom.put(quantity, samples.end());
    }
  }

  /** Forgets a quantity. */
  void untrack(ChartQuantity quantity) {
    of(quantity).remove(quantity);
    names.remove(quantity);
    knownFrom.remove(quantity);
  }

  boolean empty() {
    return samples.empty();
  }

  /** Time of the oldest sample, s; 0 without one. */
  double oldestS() {
    return empty() ? 0 : samples.timeS(samples.first());
  }

  /** Time of the newest sample, s; 0 without one. */
  double newestS() {
    return empty() ? 0 : samples.timeS(samples.end() - 1);
  }

  /** Value of a quantity at a time, that of the last sample until then; not a number before. */
  double valueAt(ChartQuantity quantity, double time) {
    return of(quantity).valueAt(quantity, time);
  }
}
