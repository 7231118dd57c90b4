package org.pendant.kit.fault;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FaultTexts {
  private static final Texts TEXTS = Texts.of(FaultTexts.class);

  private FaultTexts() {}

  /** The text of a key of {@code texts/kit.fault.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
