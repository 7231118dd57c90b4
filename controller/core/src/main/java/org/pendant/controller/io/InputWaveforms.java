package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.models.time.FrameTime;

/**
 * Input waveforms: what the world outside does with the inputs while a program runs, by the time
 * since its start. Immutable.
 */
public final class InputWaveforms {
  /** Nothing happens. */
  public static final InputWaveforms NONE = new InputWaveforms(List.of(), OptionalDouble.empty());

  /** Most changes that there may be. */
  public static final int MAX_CHANGES = 100_000;

  private final List<InputChange> changes;
  private final OptionalDouble periodS;
  private final List<Step> steps;

  /** All that changes before one frame. */
  private record Step(long frame, List<SignalWrite> writes) {}

  /**
   * Waveforms of changes in any order; of those at the same time the later one counts.
   *
   * @param periodS after which everything happens again, s; empty if it happens once
   * @throws IllegalArgumentException if there are too many changes, or some would never come
   */
  public InputWaveforms(List<InputChange> changes, OptionalDouble periodS) {
    if (changes.size() > MAX_CHANGES) {
      throw new IllegalArgumentException(text("changes", changes.size(), MAX_CHANGES));
    }
    List<InputChange> sorted = new ArrayList<>(changes);
    sorted.sort((a, b) -> Double.compare(a.timeS(), b.timeS()));
    this.changes = List.copyOf(sorted);
    this.periodS = periodS;
    if (periodS.isPresent()) {
      checkPeriod(periodS.getAsDouble());
    }
    SortedMap<Long, List<SignalWrite>> byFrame = new TreeMap<>();
    for (InputChange change : sorted) {
      byFrame
          .computeIfAbsent(frameAt(change.timeS()), frame -> new ArrayList<>())
          .addAll(change.writes());
    }
    List<Step> inOrder = new ArrayList<>();
    byFrame.forEach((frame, writes) -> inOrder.add(new Step(frame, List.copyOf(writes))));
    steps = List.copyOf(inOrder);
  }

  private void checkPeriod(double period) {
    InputChange.checkTime("period", period);
    if (period < FrameTime.FRAME_S) {
      throw new IllegalArgumentException(text("shortPeriod", period, FrameTime.FRAME_S));
    }
    if (!changes.isEmpty() && changes.getLast().timeS() >= period) {
      throw new IllegalArgumentException(
          text("changeAfterPeriod", changes.getLast().timeS(), period));
    }
  }

  private static long frameAt(double timeS) {
    return (long) Math.ceil(timeS / FrameTime.FRAME_S - FrameTime.ROUNDING);
  }

  /** All changes in the order of their times. */
  public List<InputChange> changes() {
    return changes;
  }

  /** After which time everything happens again, s; empty if it happens once. */
  public OptionalDouble periodS() {
    return periodS;
  }

  /** Frames after which everything happens again; {@link Long#MAX_VALUE} if it does not. */
  long periodFrames() {
    return periodS.isPresent() ? FrameTime.framesFor(periodS.getAsDouble()) : Long.MAX_VALUE;
  }

  /** Frames in which something changes. */
  int steps() {
    return steps.size();
  }

  /** Frames from the start of the program to step {@code index}. */
  long frame(int index) {
    return steps.get(index).frame();
  }

  /** What changes in step {@code index}. */
  List<SignalWrite> writes(int index) {
    return steps.get(index).writes();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof InputWaveforms waveforms
        && changes.equals(waveforms.changes)
        && periodS.equals(waveforms.periodS);
  }

  @Override
  public int hashCode() {
    return Objects.hash(changes, periodS);
  }

  @Override
  public String toString() {
    return WaveformText.format(this);
  }
}
