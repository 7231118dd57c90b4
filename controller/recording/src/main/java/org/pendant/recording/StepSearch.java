package org.pendant.recording;

import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntPredicate;
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

  /** The last step that is earlier than {@code from}. */
  public Optional<RecordedStep> before(Moment from) {
    return backward(from, steps(stretch -> false, step -> true));
  }

  /** The first step that is later than {@code from}. */
  public Optional<RecordedStep> after(Moment from) {
    return forward(from, steps(stretch -> false, step -> true));
  }

  /** The last wanted step to one of {@code lines} that is earlier than {@code from}. */
  public Optional<RecordedStep> before(
      Moment from, Set<Integer> lines, Predicate<RecordedStep> wanted) {
    return backward(from, steps(lines, wanted));
  }

  /** The first wanted step to one of {@code lines} that is later than {@code from}. */
  public Optional<RecordedStep> after(
      Moment from, Set<Integer> lines, Predicate<RecordedStep> wanted) {
    return forward(from, steps(lines, wanted));
  }

  /** The last change of a variable or a part of one that is earlier than {@code from}. */
  public Optional<RecordedChange> changeBefore(Moment from, VariablePath path) {
    return backward(from, changes(path));
  }

  /** The first change of a variable or a part of one that is later than {@code from}. */
  public Optional<RecordedChange> changeAfter(Moment from, VariablePath path) {
    return forward(from, changes(path));
  }

  private Wanted<RecordedStep> steps(Set<Integer> lines, Predicate<RecordedStep> wanted) {
    return steps(
        stretch -> recording.index().lacks(stretch, lines),
        step -> lines.contains(step.line()) && wanted.test(step));
  }

  private static Wanted<RecordedStep> steps(IntPredicate lacks, Predicate<RecordedStep> wanted) {
    return new Wanted<>(Steps::new, RecordedStep::moment, wanted, lacks);
  }

  private Wanted<RecordedChange> changes(VariablePath path) {
    return new Wanted<>(
        () -> new Changes(path),
        RecordedChange::moment,
        change -> true,
        stretch -> recording.index().lacks(stretch, path.name()));
  }

  /**
   * What is looked for.
   *
   * @param begin begins to look
   * @param moment when something is
   * @param wanted whether it is meant
   * @param lacks whether a stretch has nothing of it
   */
  private record Wanted<T>(
      Supplier<Look<T>> begin,
      Function<T, Moment> moment,
      Predicate<T> wanted,
      IntPredicate lacks) {
    Optional<T> in(Optional<T> found, Predicate<Moment> when) {
      return found.filter(each -> when.test(moment.apply(each))).filter(wanted);
    }
  }

  /** Looks at entries in turn. */
  interface Look<T> {
    /** What the next entry brings, compared with the one before. */
    Optional<T> at(SegmentCursor entry);
  }

  private <T> Optional<T> backward(Moment from, Wanted<T> what) {
    for (int i = recording.stretchOf(from.frame()); i >= 0; i--) {
      if (what.lacks().test(i)) {
        continue;
      }
      Optional<T> newest = Optional.empty();
      Look<T> look = begin(what, i);
      SegmentCursor entry = recording.entries(i);
      while (entry.next() && entry.frame() <= from.frame()) {
        Optional<T> found = what.in(look.at(entry), moment -> moment.compareTo(from) < 0);
        newest = found.isPresent() ? found : newest;
      }
      if (newest.isPresent()) {
        return newest;
      }
    }
    return Optional.empty();
  }

  private <T> Optional<T> forward(Moment from, Wanted<T> what) {
    // a frame that was paused may begin in the stretch before the one that it ends in
    for (int i = recording.stretchOf(from.frame() - 1); i < recording.stretches(); i++) {
      if (what.lacks().test(i)) {
        continue;
      }
      Look<T> look = begin(what, i);
      SegmentCursor entry = recording.entries(i);
      while (entry.next() && entry.frame() <= recording.lastFrame()) {
        Optional<T> found = what.in(look.at(entry), moment -> moment.compareTo(from) > 0);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  /** Looks at what was before a stretch. */
  private <T> Look<T> begin(Wanted<T> what, int stretch) {
    Look<T> look = what.begin().get();
    if (stretch > 0) {
      look.at(recording.lastEntry(stretch - 1));
    }
    return look;
  }

  private static DebugState debug(SegmentCursor entry) {
    return (DebugState) entry.part(SnapshotPart.DEBUG);
  }

  private static Moment moment(SegmentCursor entry) {
    return Moment.of(entry.frame(), debug(entry));
  }

  /** Where another statement begins. */
  static final class Steps implements Look<RecordedStep> {
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
  }

  /** Whether a variable has the same value, or none, in both. */
  static boolean same(Optional<VariableSample> one, Optional<VariableSample> other) {
    return one.equals(other) || value(one).equals(value(other));
  }

  private static Optional<Value> value(Optional<VariableSample> sample) {
    return sample.flatMap(VariableSample::value);
  }
}
