package org.pendant.gui.debug;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.source.ByteText;

/**
 * Values as rows that unfold. Only what is unfolded is asked for, a page at a time. It has no
 * Swing; one thread uses it, the dispatch thread.
 */
final class ValueTree {
  /** Parts that are shown at first, and that come with each step. */
  static final int PAGE = 100;

  private final DebugLink link;
  private final Roots roots;
  private final Runnable assigned;
  private final List<Runnable> listeners = new ArrayList<>();
  private final Map<ValueKey, Integer> unfolded = new HashMap<>();
  private final Map<ValueKey, Refusal> refusals = new HashMap<>();
  private Map<ValueKey, String> before = Map.of();
  private Map<ValueKey, String> now = new HashMap<>();
  private Optional<Scope> scope = Optional.empty();
  private List<ValueNode.Group> groups = List.of();
  private List<ValueRow> rows = List.of();
  private long asked;

  /** Where its values come from. */
  @FunctionalInterface
  interface Roots {
    /** Reads them, in the frame loop. */
    List<ValueNode.Group> of(ValueReader reader, Scope scope);
  }

  /** A change that was refused, and what was typed. */
  private record Refusal(String typed, String why) {}

  /**
   * A tree without values.
   *
   * @param assigned told when a value was changed through this tree
   */
  ValueTree(DebugLink link, Roots roots, Runnable assigned) {
    this.link = link;
    this.roots = roots;
    this.assigned = assigned;
  }

  List<ValueRow> rows() {
    return rows;
  }

  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** The program is held anew: what is different from now is marked. */
  void stopped() {
    before = now;
    now = new HashMap<>();
    refusals.clear();
    unfolded.replaceAll((key, shown) -> PAGE);
  }

  /** Reads everything that is unfolded again, as the call {@code wanted} sees it. */
  void load(Scope wanted) {
    scope = Optional.of(wanted);
    reload();
  }

  /** As {@link #load}, in the same call. */
  void reload() {
    if (scope.isEmpty()) {
      return;
    }
    Scope wanted = scope.get();
    Map<ValueKey, Integer> parts = Map.copyOf(unfolded);
    long number = ++asked;
    link.ask(
        debugger -> roots.of(new ValueReader(debugger, parts), wanted),
        found -> {
          if (number == asked) {
            show(found);
          }
        },
        // Let go in the meantime; the next stop asks again.
        refused -> {});
  }

  /** Shows {@code idle} while nothing is held. */
  void clear(List<ValueNode.Group> idle) {
    scope = Optional.empty();
    asked++;
    show(idle);
  }

  private void show(List<ValueNode.Group> found) {
    groups = found;
    layOut();
  }

  private void layOut() {
    List<ValueRow> laid = new ArrayList<>();
    for (ValueNode.Group group : groups) {
      if (!group.title().isEmpty()) {
        laid.add(new ValueRow.Heading(group.title()));
      }
      group.nodes().forEach(node -> add(laid, group.scope(), node, 0));
    }
    rows = List.copyOf(laid);
    listeners.forEach(Runnable::run);
  }

  private void add(List<ValueRow> laid, Scope in, ValueNode node, int level) {
    ValueKey key = new ValueKey(in, node.variable().expression());
    if (scope.isPresent() && node.variable().kind().isPresent()) {
      now.put(key, node.variable().text());
    }
    String old = before.get(key);
    boolean changed = scope.isPresent() && old != null && !old.equals(node.variable().text());
    boolean open = unfolded.containsKey(key) && node.variable().children() > 0;
    laid.add(new ValueRow.Value(key, node.variable(), level, open, changed));
    if (!node.failure().isEmpty()) {
      laid.add(new ValueRow.Problem(key, level, node.failure()));
    }
    Refusal refusal = refusals.get(key);
    if (refusal != null) {
      laid.add(new ValueRow.Problem(key, level, "Not changed: " + refusal.why()));
    }
    if (!open) {
      return;
    }
    node.parts().forEach(part -> add(laid, in, part, level + 1));
    if (!node.parts().isEmpty() && node.parts().size() < node.variable().children()) {
      laid.add(new ValueRow.More(key, level + 1, node.parts().size(), node.variable().children()));
    }
  }

  /** Unfolds or folds a value. */
  void toggle(ValueRow.Value row) {
    if (!row.hasParts()) {
      return;
    }
    if (unfolded.remove(row.key()) == null) {
      unfolded.put(row.key(), PAGE);
      reload();
    } else {
      layOut();
    }
  }

  /** Shows the next page of parts. */
  void showMore(ValueRow.More row) {
    unfolded.merge(row.key(), PAGE, Integer::sum);
    reload();
  }

  /** Whether values can be changed now. */
  boolean canAssign() {
    return scope.isPresent();
  }

  /** What an editor of the value begins with: what was refused before, or what it is. */
  String toEdit(ValueRow.Value row) {
    Refusal refusal = refusals.get(row.key());
    return refusal == null ? row.text() : refusal.typed();
  }

  /** Changes a value; a refusal is shown below it. */
  void assign(ValueRow.Value row, String typed) {
    ValueKey key = row.key();
    if (typed.strip().equals(row.text()) && !refusals.containsKey(key)) {
      return;
    }
    link.ask(
        debugger ->
            debugger.assign(
                key.scope().thread(),
                key.scope().depth(),
                key.expression(),
                ByteText.asBytes(typed)),
        done -> {
          refusals.remove(key);
          assigned.run();
        },
        why -> {
          refusals.put(key, new Refusal(typed, why));
          layOut();
        });
  }

  /** Forgets a refusal; the value stays as it is. */
  void dismiss(ValueKey key) {
    if (refusals.remove(key) != null) {
      layOut();
    }
  }
}
