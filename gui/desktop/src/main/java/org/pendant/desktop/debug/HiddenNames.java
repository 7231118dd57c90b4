package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.List;
import org.pendant.kit.settings.Settings;
import org.pendant.project.program.script.GeneratedNames;

/**
 * Hidden names: variables that the script of a program tree needs and nobody has named, such as the
 * poses of its waypoints. They are listed only when people want to see them. One thread uses it,
 * the dispatch thread.
 */
public final class HiddenNames {
  private static final String SETTING = "variables.generated";

  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();
  private GeneratedNames names = GeneratedNames.NONE;

  /** Hides none until a program has been started. */
  public HiddenNames(Settings settings) {
    this.settings = settings;
  }

  /** A program starts, or one of which nothing is known ({@link GeneratedNames#NONE}). */
  public void start(GeneratedNames now) {
    if (!now.equals(names)) {
      names = now;
      listeners.forEach(Runnable::run);
    }
  }

  /** Whether a variable of the program called {@code program} is left out of lists. */
  public boolean hides(String program, String variable) {
    return !shown() && program.equals(names.program()) && names.variables().contains(variable);
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
