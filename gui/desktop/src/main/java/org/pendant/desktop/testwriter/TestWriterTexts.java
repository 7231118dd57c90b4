package org.pendant.desktop.testwriter;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class TestWriterTexts {
  private static final Texts TEXTS = Texts.of(TestWriterTexts.class, Messages::shown);

  private TestWriterTexts() {}

  /** The text of a key of {@code texts/desktop.testwriter.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
