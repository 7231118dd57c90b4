package org.pendant.protocols.dashboard;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DashboardTexts {
  private static final Texts TEXTS = Texts.english(DashboardTexts.class);

  private DashboardTexts() {}

  /** The text of a key of {@code texts/protocols.dashboard.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
