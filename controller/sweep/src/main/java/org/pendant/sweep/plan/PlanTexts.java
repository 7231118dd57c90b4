package org.pendant.sweep.plan;

import org.pendant.text.Texts;

/** What this package says to people. */
final class PlanTexts {
  private static final Texts TEXTS = Texts.english(PlanTexts.class);

  private PlanTexts() {}

  /** The text of a key of {@code texts/sweep.plan.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
