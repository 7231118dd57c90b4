package org.pendant.controller.rule;

import org.pendant.text.Texts;

/** What this package says to people. */
final class RuleTexts {
  private static final Texts TEXTS = Texts.english(RuleTexts.class);

  private RuleTexts() {}

  /** The text of a key of {@code texts/controller.rule.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
