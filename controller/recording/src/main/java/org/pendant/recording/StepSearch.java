package org.pendant.recording;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.script.debug.DebugState;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/**
 * Step search: finds where the program of a recording came to another statement, and where a
 * variable changed, before or after a moment. What is near is found at once. Going through ten
 * minutes of an arm that moves takes some hundredths of a second in memory; a file is read for it,
 * so that is not for the dispatch thread.
 */
public final class StepSearch {
  private final Recording recording;

  /** Searches {@code recording}. */
  public StepSearch(Recording recording) {
    this.recording = recording;
  }

  /** The last wanted step that is earlier than {@code from}. */
  public Optional<RecordedStep> before(Moment from, Predicate<RecordedStep> wanted) {
    return backward(from, Steps::new, RecordedStep::moment, wanted);
  }

  /** The first wanted step that is later than {@code from}. */
  public Optional<RecordedStep> after(Moment from, Predicate<RecordedStep> wanted) {
    return forward(from, Steps::new, RecordedStep::moment, wanted);
  }

  /** The last change of a variable or a part of one that is earlier than {@code from}. */
  public Optional<RecordedChange> changeBefore(Moment from, VariablePath path) {
    return backward(from, () -> new Changes(path), RecordedChange::moment, change -> true);
  }

  /** The first change of a variable or a part of one that is later than {@code from}. */
  public Optional<RecordedChange> changeAfter(Moment from, VariablePath path) {
    return forward(from, () -> new Changes(path), RecordedChange::moment, change -> true);
  }

  /** Looks at entries in turn. */
  private interface Look<T> {
    /** What the next entry brings, compared with the one before. */
    Optional<T> at(SegmentCursor entry);
  }

  private <T> Optional<T> backward(
      Moment from, Supplier<Look<T>> begin, Function<T, Moment> moment, Predicate<T> wanted) {
    for (int i = recording.stretchOf(from.frame()); i >= 0; i--) {
      Optional<T> newest = Optional.empty();
      Look<T> look = begin.get();
      if (i > 0) {
        look.at(recording.lastEntry(i - 1));
      }
      SegmentCursor entry = recording.entries(i);
      while (entry.next() && entry.frame() <= from.frame()) {
        Optional<T> found =
            look.at(entry).filter(each -> moment.apply(each).compareTo(from) < 0).filter(wanted);
        newest = found.isPresent() ? found : newest;
      }
      if (newest.isPresent()) {
        return newest;
      }
    }
    return Optional.empty();
  }

  private <T> Optional<T> forward(
      Moment from, Supplier<Look<T>> begin, Function<T, Moment> moment, Predicate<T> wanted) {
    Look<T> look = begin.get();
    // a frame that was paused may begin in the stretch before the one that it ends in
    int first = recording.stretchOf(from.frame() - 1);
    if (first > 0) {
      look.at(recording.lastEntry(first - 1));
    }
    for (int i = first; i < recording.stretches(); i++) {
      SegmentCursor entry = recording.entries(i);
      while (entry.next() && entry.frame() <= recording.lastFrame()) {
        Optional<T> found =
            look.at(entry).filter(each -> moment.apply(each).compareTo(from) > 0).filter(wanted);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  private static DebugState debug(SegmentCursor entry) {
    return (DebugState) entry.part(SnapshotPart.DEBUG);
  }

  private static Moment moment(SegmentCursor entry) {
    return Moment.of(entry.frame(), debug(entry));
  }

  /** Where another statement begins. */
  private static final class Steps implements Look<RecordedStep> {
    private int line;
    private long stop;

    @Override
    public Optional<RecordedStep> at(SegmentCursor entry) {
      int now = ((ProgramStatus) entry.part(SnapshotPart.PROGRAM)).line();
      Optional<DebugState.Stop> held = debug(entry).stop();
      boolean stopped = held.isPresent() && held.get().number() != stop;
      boolean moved = held.isEmpty() && now > 0 && now != line;
      stop = held.map(DebugState.Stop::number).orElse(stop);
      line = now;
      return stopped || moved
          ? Optional.of(
              new RecordedStep(
                  moment(entry),
                  held.map(DebugState.Stop::line).orElse(now),
                  held,
                  (VariableSamples) entry.part(SnapshotPart.VARIABLES)))
          : Optional.empty();
    }
  }

  /** Where a variable has another value. */
  private static final class Changes implements Look<RecordedChange> {
    private final VariablePath path;
    private Optional<VariableSamples> samples = Optional.empty();
    private Optional<VariableSample> value = Optional.empty();

    Changes(VariablePath path) {
      this.path = path;
    }

    @Override
    public Optional<RecordedChange> at(SegmentCursor entry) {
      VariableSamples now = (VariableSamples) entry.part(SnapshotPart.VARIABLES);
      if (samples.filter(now::equals).isPresent()) {
        return Optional.empty();
      }
      Optional<VariableSample> before = value;
      boolean first = samples.isEmpty();
      samples = Optional.of(now);
      value = now.find(path);
      return first || same(before, value)
          ? Optional.empty()
          : Optional.of(new RecordedChange(moment(entry), before, value));
    }

    private static boolean same(Optional<VariableSample> one, Optional<VariableSample> other) {
      return one.equals(other) || value(one).equals(value(other));
    }

    private static Optional<Value> value(Optional<VariableSample> sample) {
      return sample.flatMap(VariableSample::value);
    }
  }
}
