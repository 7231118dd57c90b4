package org.pendant.desktop.program.form;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class FormTexts {
  private static final Texts TEXTS = Texts.of(FormTexts.class, Messages::shown);

  private FormTexts() {}

  /** The text of a key of {@code texts/desktop.program.form.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
