package org.pendant.desktop.tests;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class TestsTexts {
  private static final Texts TEXTS = Texts.of(TestsTexts.class, Messages::shown);

  private TestsTexts() {}

  /** The text of a key of {@code texts/desktop.tests.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
