package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Variable;

/**
 * Value tree: values as rows that unfold. Only what is unfolded is asked for, a page at a time. It
 * has no Swing; one thread uses it, the dispatch thread.
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
  private final ValueChanges changes = new ValueChanges();
  private ValueOrder order = ValueOrder.PLAIN;
  private Optional<Live> live = Optional.empty();
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

  /**
   * How the values of a program that runs are shown.
   *
   * @param source makes them of what is unfolded
   * @param atMs when they were taken, by any clock
   * @param changeable whether global variables can be changed
   */
  private record Live(LiveSource source, long atMs, boolean changeable) {}

  /** The values of a program that runs. */
  @FunctionalInterface
  interface LiveSource {
    /** The values with so many parts of those that are unfolded. */
    List<ValueNode.Group> of(Map<ValueKey, Integer> unfolded);
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

  /** The value of a variable, as text: a local one before a global one; empty if it has none. */
  Optional<String> text(String name) {
    return groups.stream()
        .flatMap(group -> group.nodes().stream())
        .map(ValueNode::variable)
        .filter(each -> each.name().equals(name) && each.kind().isPresent())
        .map(Variable::text)
        .findFirst();
  }

  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** The program is paused anew: what is different from now is marked. */
  void stopped() {
    changes.stopped();
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
      live.ifPresent(each -> show(each.source().of(unfolded())));
      return;
    }
    live = Optional.empty();
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

  /** Shows {@code idle} while nothing is paused. */
  void clear(List<ValueNode.Group> idle) {
    scope = Optional.empty();
    live = Optional.empty();
    asked++;
    show(idle);
  }

  /**
   * Shows values of a program that is not paused.
   *
   * @param nowMs time of any clock
   * @param changeable whether global variables can be changed
   */
  void showLive(LiveSource source, long nowMs, boolean changeable) {
    scope = Optional.empty();
    asked++;
    live = Optional.of(new Live(source, nowMs, changeable));
    show(source.of(unfolded()));
  }

  /**
   * Whether {@link #showLive} would show anything else at {@code nowMs} although no value changed.
   */
  boolean fades(long nowMs) {
    return live.isPresent() && changes.fades(live.get().atMs(), nowMs);
  }

  /** Whether what is shown comes from {@link #showLive}. */
  boolean showsLive() {
    return live.isPresent();
  }

  /** Another program was started: its values are all new. */
  void programStarted() {
    changes.forgetLive();
    refusals.clear();
  }

  /** How many parts are wanted of the values that are unfolded. */
  Map<ValueKey, Integer> unfolded() {
    return Map.copyOf(unfolded);
  }

  /** Shows the same values in another order. */
  void setOrder(ValueOrder wanted) {
    order = wanted;
    layOut();
  }

  private void show(List<ValueNode.Group> found) {
    groups = found;
    layOut();
  }

  private void layOut() {
    List<ValueRow> laid = new ArrayList<>();
    for (ValueNode.Group group : groups) {
      List<ValueNode> shown = order.of(group.nodes());
      if (!group.title().isEmpty() && !shown.isEmpty()) {
        laid.add(new ValueRow.Heading(group.title()));
      }
      shown.forEach(node -> add(laid, group.scope(), node, 0));
    }
    rows = List.copyOf(laid);
    listeners.forEach(Runnable::run);
  }

  private void add(List<ValueRow> laid, Scope in, ValueNode node, int level) {
    ValueKey key = new ValueKey(in, node.variable().expression());
    boolean open = unfolded.containsKey(key) && node.variable().children() > 0;
    boolean favourite = level == 0 && order.favourite().test(key.expression());
    laid.add(new ValueRow.Value(key, node.variable(), level, open, change(key, node), favourite));
    if (!node.failure().isEmpty()) {
      laid.add(new ValueRow.Problem(key, level, node.failure()));
    }
    Refusal refusal = refusals.get(key);
    if (refusal != null) {
      laid.add(new ValueRow.Problem(key, level, DebugTexts.text("notChanged", refusal.why())));
    }
    if (!open) {
      return;
    }
    node.parts().forEach(part -> add(laid, in, part, level + 1));
    int count = node.parts().size();
    if (count > 0 && count < node.variable().children()) {
      boolean cut = live.isPresent() && count < unfolded.get(key);
      laid.add(new ValueRow.More(key, level + 1, count, node.variable().children(), cut));
    }
  }

  private ValueRow.Change change(ValueKey key, ValueNode node) {
    if (node.variable().kind().isEmpty()) {
      return ValueRow.Change.NONE;
    }
    String text = node.variable().text();
    return scope.isPresent()
        ? changes.held(key, text)
        : live.map(each -> changes.live(key, text, each.atMs())).orElse(ValueRow.Change.NONE);
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

  /** Whether a value can be changed now: a local one only while its call is paused. */
  boolean canAssign(ValueRow.Value row) {
    return scope.isPresent()
        || (live.filter(Live::changeable).isPresent() && row.key().scope().equals(Scope.GLOBAL));
  }

  /** Why a value cannot be changed now; empty if it can. */
  String whyFixed(ValueRow.Value row) {
    if (canAssign(row)) {
      return "";
    }
    return live.filter(Live::changeable).isPresent()
        ? DebugTexts.text("pauseInTheDebuggerToChange")
        : DebugTexts.text("itCanBeChangedWhileThe");
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
