package org.pendant.desktop.program;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToLongFunction;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.editor.LineIcon;
import org.pendant.desktop.editor.LineNote;

/**
 * Tree marks: breakpoints, the execution point and other threads beside the nodes of a tree, by the
 * keys of the nodes.
 *
 * @param breakpoints how each looks
 * @param execution the node where the program is; 0 for none
 * @param state what the program does there
 * @param note why it is paused or has failed; empty without a reason
 * @param threads nodes where other threads of the program are
 * @param notes what nodes took of the last run
 */
record TreeMarks(
    Map<Long, LineIcon.Dot> breakpoints,
    long execution,
    Execution.State state,
    String note,
    Set<Long> threads,
    Map<Long, LineNote> notes) {
  static final TreeMarks NONE =
      new TreeMarks(Map.of(), 0, Execution.State.RUNNING, "", Set.of(), Map.of());

  TreeMarks {
    breakpoints = Map.copyOf(breakpoints);
    threads = Set.copyOf(threads);
    notes = Map.copyOf(notes);
  }

  /** The same marks moved to other nodes, such as visible ones instead of those in folded ones. */
  TreeMarks at(ToLongFunction<Long> place) {
    Map<Long, LineIcon.Dot> dots = new HashMap<>();
    breakpoints.forEach((key, dot) -> dots.putIfAbsent(place.applyAsLong(key), dot));
    Set<Long> others = new HashSet<>();
    threads.forEach(key -> others.add(place.applyAsLong(key)));
    return new TreeMarks(
        dots, execution == 0 ? 0 : place.applyAsLong(execution), state, note, others, notes);
  }

  /** What is drawn beside a node; empty for nothing. */
  Optional<LineIcon> icon(long key) {
    Optional<LineIcon.Dot> dot = Optional.ofNullable(breakpoints.get(key));
    Optional<Execution.State> arrow = key == execution ? Optional.of(state) : Optional.empty();
    return dot.isEmpty() && arrow.isEmpty()
        ? Optional.empty()
        : Optional.of(new LineIcon(dot, arrow, false));
  }
}
