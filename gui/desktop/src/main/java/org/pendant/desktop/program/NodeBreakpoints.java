package org.pendant.desktop.program;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.GeneratedScript.NodeLines;

/**
 * Node breakpoints: which nodes of a program the breakpoints in its script stand beside. A node and
 * the first one below it often begin with the same line, so what the user chose in the tree is kept
 * by node; a breakpoint that was set in the script stands at the innermost node of its line.
 */
final class NodeBreakpoints {
  /** The line of each node at which the user has set a breakpoint in the tree, by key. */
  private final Map<Long, Integer> chosen = new HashMap<>();

  /** The breakpoints of a script. */
  interface Lines {

    /** The lines that have one. */
    SortedSet<Integer> all();

    /** Sets or clears one, on that line or the next one where a program can stop. */
    void toggle(int line);
  }

  /** The nodes that the breakpoint of a line stands beside. */
  Set<Long> nodes(GeneratedScript script, int line) {
    Set<Long> keys = new HashSet<>();
    chosen.forEach(
        (key, own) -> {
          if (own == line) {
            keys.add(key);
          }
        });
    if (keys.isEmpty()) {
      script.at(line).map(NodeLines::key).ifPresent(keys::add);
    }
    return keys;
  }

  /** Breakpoints that have been cleared in the script are no more at any node. */
  void forgetCleared(Lines lines) {
    chosen.values().retainAll(lines.all());
  }

  /**
   * Sets a breakpoint where a node begins, or clears those that stand beside it.
   *
   * @return whether that could be: some nodes generate nothing
   */
  boolean toggle(GeneratedScript script, long key, Lines lines) {
    forgetCleared(lines);
    SortedSet<Integer> beside = new TreeSet<>(lines.all());
    beside.removeIf(line -> !nodes(script, line).contains(key));
    if (!beside.isEmpty()) {
      chosen.remove(key);
      beside.stream().filter(line -> !chosen.containsValue(line)).forEach(lines::toggle);
      return true;
    }
    Optional<NodeLines> place = script.of(key);
    place.ifPresent(each -> set(script, key, each.first(), lines));
    return place.isPresent();
  }

  private void set(GeneratedScript script, long key, int first, Lines lines) {
    SortedSet<Integer> before = new TreeSet<>(lines.all());
    lines.toggle(first);
    SortedSet<Integer> now = new TreeSet<>(lines.all());
    now.removeAll(before);
    if (!now.isEmpty()) {
      chosen.put(key, now.getFirst());
      return;
    }
    // There was one already, at another node that begins there; both have it from now on.
    before.removeAll(lines.all());
    if (!before.isEmpty()) {
      int line = before.getFirst();
      nodes(script, line).forEach(each -> chosen.put(each, line));
      lines.toggle(line);
      chosen.put(key, line);
    }
  }

  /** Where a breakpoint is when the script is another one; 0 if its node is no more. */
  int moved(GeneratedScript before, GeneratedScript now, int line) {
    Set<Long> keys = nodes(before, line);
    if (keys.isEmpty()) {
      return line <= now.text().lines().count() ? line : 0;
    }
    return keys.stream().sorted().mapToInt(key -> moved(before, now, key, line)).max().orElse(0);
  }

  /** As far below the first line of its node as it was. */
  private static int moved(GeneratedScript before, GeneratedScript now, long key, int line) {
    int below = line - before.of(key).map(NodeLines::first).orElse(line);
    return now.of(key).map(place -> Math.min(place.last(), place.first() + below)).orElse(0);
  }

  /**
   * The script is another one, and its breakpoints are where {@link #moved} says: nodes that do not
   * begin with the same line any more get a breakpoint each.
   */
  void follow(GeneratedScript before, GeneratedScript now, Lines lines) {
    for (Map.Entry<Long, Integer> each : List.copyOf(chosen.entrySet())) {
      int line = moved(before, now, each.getKey(), each.getValue());
      chosen.remove(each.getKey());
      if (line > 0 && lines.all().contains(line)) {
        chosen.put(each.getKey(), line);
      } else if (line > 0) {
        set(now, each.getKey(), line, lines);
      }
    }
  }
}
