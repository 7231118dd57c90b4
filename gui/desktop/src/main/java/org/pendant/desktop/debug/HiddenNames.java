package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.pendant.kit.settings.Settings;
import org.pendant.project.program.script.GeneratedNames;

/**
 * Hidden names: variables that the script of a program tree needs and nobody has named, such as the
 * poses of its waypoints. They are listed only when people want to see them. One thread uses it,
 * the dispatch thread.
 */
public final class HiddenNames {
  /** Programs whose names are remembered, those that were started last. */
  private static final int MAX_PROGRAMS = 200;

  private static final String SETTING = "variables.generated";

  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();
  private final Map<String, Set<String>> variables = new LinkedHashMap<>();

  /** Hides none until a program has been started. */
  public HiddenNames(Settings settings) {
    this.settings = settings;
  }

  /**
   * A program starts. Its names stay hidden when others start: people look back at it, run it again
   * from outside, or run the script that they saved of it.
   */
  public void start(GeneratedNames now) {
    if (now.equals(GeneratedNames.NONE)) {
      return;
    }
    Set<String> before = variables.remove(now.program());
    variables.put(now.program(), now.variables());
    if (variables.size() > MAX_PROGRAMS) {
      variables.remove(variables.keySet().iterator().next());
    }
    if (!now.variables().equals(before)) {
      listeners.forEach(Runnable::run);
    }
  }

  /** Whether a variable of the program called {@code program} is left out of lists. */
  public boolean hides(String program, String variable) {
    return !shown() && variables.getOrDefault(program, Set.of()).contains(variable);
  }

  boolean shown() {
    return settings.get(SETTING).filter("shown"::equals).isPresent();
  }

  void toggle() {
    settings.put(SETTING, shown() ? "hidden" : "shown");
    listeners.forEach(Runnable::run);
  }

  /** Tells {@code listener} when others are hidden. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }
}
