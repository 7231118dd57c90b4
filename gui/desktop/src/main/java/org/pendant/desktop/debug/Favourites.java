package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.kit.settings.Settings;

/**
 * Favourite variables: come first wherever variables are listed: some for each program, by its
 * name, kept in the settings. One thread uses it, the dispatch thread.
 */
public final class Favourites {
  private static final String SETTING = "variables.favourites.";

  private final Settings settings;
  private final List<Runnable> listeners = new ArrayList<>();

  /** Those that the settings remember. */
  public Favourites(Settings settings) {
    this.settings = settings;
  }

  /** The favourites of a program, in the order in which they became so. */
  public Set<String> of(String program) {
    return settings
        .get(setting(program))
        .map(
            text ->
                text.lines()
                    .filter(line -> !line.isBlank())
                    .collect(Collectors.toCollection(LinkedHashSet::new)))
        .orElseGet(LinkedHashSet::new);
  }

  /** Makes a variable a favourite of a program, or no longer one. */
  public void toggle(String program, String variable) {
    Set<String> changed = of(program);
    if (!changed.remove(variable)) {
      changed.add(variable);
    }
    settings.put(setting(program), String.join("\n", changed));
    listeners.forEach(Runnable::run);
  }

  /** Tells {@code listener} when a favourite comes or goes. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Names of programs may have characters that names of settings do not have. */
  private static String setting(String program) {
    StringBuilder name = new StringBuilder(SETTING);
    for (int i = 0; i < program.length(); i++) {
      char c = program.charAt(i);
      boolean plain = c == '_' || (c < 128 && Character.isLetterOrDigit(c));
      name.append(plain ? String.valueOf(c) : "-" + Integer.toHexString(c) + "-");
    }
    return name.toString();
  }
}
