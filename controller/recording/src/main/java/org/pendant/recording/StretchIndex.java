package org.pendant.recording;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/**
 * Stretch index: what begins in each stretch of a recording of a file, so that those which cannot
 * have what is looked for need not be read. It is made once, by going through the recording; what
 * is not made yet is taken to have everything. Any thread.
 */
final class StretchIndex {
  private final AtomicReferenceArray<Contents> known;

  /**
   * What begins in a stretch.
   *
   * @param lines of the statements that the program comes to
   * @param variables that change, by their names
   */
  private record Contents(Set<Integer> lines, Set<String> variables) {
    Contents {
      lines = Set.copyOf(lines);
      variables = Set.copyOf(variables);
    }
  }

  /** Of a recording with so many stretches; nothing is known yet. */
  StretchIndex(int stretches) {
    known = new AtomicReferenceArray<>(stretches);
  }

  /** Whether no statement of these lines begins in a stretch. */
  boolean lacks(int stretch, Set<Integer> lines) {
    Contents contents = known.get(stretch);
    return contents != null && lines.stream().noneMatch(contents.lines()::contains);
  }

  /** Whether a variable does not change in a stretch. */
  boolean lacks(int stretch, String variable) {
    Contents contents = known.get(stretch);
    return contents != null && !contents.variables().contains(variable);
  }

  /** Goes through {@code recording}, whose index this is. */
  void make(Recording recording) {
    StepSearch.Steps steps = new StepSearch.Steps();
    Optional<VariableSamples> samples = Optional.empty();
    for (int i = 0; i < recording.stretches(); i++) {
      Set<Integer> lines = new HashSet<>();
      Set<String> variables = new HashSet<>();
      SegmentCursor entry = recording.entries(i);
      while (entry.next()) {
        steps.at(entry).ifPresent(step -> lines.add(step.line()));
        if (entry.changed(SnapshotPart.VARIABLES)) {
          VariableSamples now = (VariableSamples) entry.part(SnapshotPart.VARIABLES);
          samples.ifPresent(before -> addChanges(before, now, variables));
          samples = Optional.of(now);
        }
      }
      known.set(i, new Contents(lines, variables));
    }
  }

  private static void addChanges(
      VariableSamples before, VariableSamples now, Set<String> variables) {
    if (!before.equals(now)) {
      addChanges(before.globals(), now.globals(), variables);
      addChanges(before.locals(), now.locals(), variables);
    }
  }

  private static void addChanges(
      List<VariableSample> before, List<VariableSample> now, Set<String> variables) {
    Map<String, VariableSample> left = new HashMap<>();
    before.forEach(each -> left.put(each.name(), each));
    for (VariableSample each : now) {
      Optional<VariableSample> old = Optional.ofNullable(left.remove(each.name()));
      if (!StepSearch.same(old, Optional.of(each))) {
        variables.add(each.name());
      }
    }
    variables.addAll(left.keySet());
  }
}
