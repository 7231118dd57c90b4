package org.pendant.kit.theme;

import static org.pendant.kit.theme.ThemeTexts.text;

import java.util.Locale;

/** Theme: which colours the desktop has. */
public enum Theme {
  LIGHT(text("light")),
  DARK(text("dark")),
  /** As the rest of the desktop, as far as that can be found out. */
  SYSTEM(text("asTheSystem"));

  private final String title;

  Theme(String title) {
    this.title = title;
  }

  /** What people read. */
  public String title() {
    return title;
  }

  /** The word in settings. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The theme of that word; the system's for words that are none. */
  public static Theme of(String word) {
    for (Theme each : values()) {
      if (each.word().equals(word)) {
        return each;
      }
    }
    return SYSTEM;
  }
}
