package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.eclipse.lsp4j.debug.Source;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;

/** Breakpoint table: what breakpoints a client has set, and where the debugger is to have them. */
final class BreakpointTable {
  /** Texts that may have breakpoints. */
  static final int MAX_SOURCES = 1000;

  /** Breakpoints of a text, and of functions. */
  static final int MOST = 1000;

  private final Map<String, OfSource> sources = new TreeMap<>();
  private List<Wanted> functions = List.of();
  private Set<Integer> installed = Set.of();
  private int lastId;

  /**
   * A breakpoint that a client has set.
   *
   * @param id by which it is told of
   * @param line from 1; for a function the one of its first statement, 0 if there is none
   * @param breakpoint for the debugger, on that line
   * @param refusal why it cannot be; empty if it can
   */
  record Wanted(int id, int line, Optional<Breakpoint> breakpoint, Optional<String> refusal) {}

  /** The breakpoints of a text. */
  record OfSource(Source source, List<Wanted> all) {
    OfSource {
      all = List.copyOf(all);
    }
  }

  int nextId() {
    return ++lastId;
  }

  /** Has {@code all} take the place of those of a text. */
  void set(Source source, List<Wanted> all) {
    String key = source.getPath() + "#" + source.getSourceReference();
    if (all.isEmpty()) {
      sources.remove(key);
    } else if (sources.size() < MAX_SOURCES || sources.containsKey(key)) {
      sources.put(key, new OfSource(source, all));
    } else {
      throw Refusals.of(text("tooManyFilesWithBreakpoints", MAX_SOURCES));
    }
  }

  /** Has {@code all} take the place of those of functions. */
  void setFunctions(List<Wanted> all) {
    functions = List.copyOf(all);
  }

  List<OfSource> sources() {
    return List.copyOf(sources.values());
  }

  /** Those of the text that {@code meant} takes. */
  private List<Wanted> of(Predicate<Source> meant) {
    return sources.values().stream()
        .filter(each -> meant.test(each.source()))
        .flatMap(each -> each.all().stream())
        .toList();
  }

  /** What the debugger is to have, by line; where two want the same line, the last counts. */
  SortedMap<Integer, Breakpoint> wanted(Predicate<Source> meant) {
    SortedMap<Integer, Breakpoint> lines = new TreeMap<>();
    functions.forEach(each -> each.breakpoint().ifPresent(it -> lines.put(it.line(), it)));
    of(meant).forEach(each -> each.breakpoint().ifPresent(it -> lines.put(it.line(), it)));
    return lines;
  }

  /** The ids of those that are set on a line, those of functions apart. */
  Hit at(int line, Predicate<Source> meant) {
    return new Hit(ids(of(meant), line), ids(functions, line));
  }

  private static List<Integer> ids(List<Wanted> among, int line) {
    return among.stream()
        .filter(each -> each.breakpoint().filter(it -> it.line() == line).isPresent())
        .map(Wanted::id)
        .toList();
  }

  /**
   * The breakpoints of a line.
   *
   * @param lines ids of those that were set on it
   * @param functions ids of those of a function that begins there
   */
  record Hit(List<Integer> lines, List<Integer> functions) {
    Integer[] ids() {
      List<Integer> all = new ArrayList<>(lines);
      all.addAll(functions);
      return all.toArray(Integer[]::new);
    }
  }

  /** What brings a debugger from what it was told last to what is wanted; hits are kept. */
  Consumer<Debugger> installation(SortedMap<Integer, Breakpoint> wanted) {
    Set<Integer> gone = new HashSet<>(installed);
    gone.removeAll(wanted.keySet());
    installed = Set.copyOf(wanted.keySet());
    List<Breakpoint> all = List.copyOf(wanted.values());
    return debugger -> {
      gone.forEach(debugger::remove);
      all.forEach(debugger::set);
    };
  }

  /** Another debugger has none yet. */
  void forgetInstalled() {
    installed = Set.of();
  }
}
