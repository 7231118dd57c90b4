package org.pendant.sweep.report;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ReportTexts {
  private static final Texts TEXTS = Texts.english(ReportTexts.class);

  private ReportTexts() {}

  /** The text of a key of {@code texts/sweep.report.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
