package org.pendant.kit.form;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FormFieldTexts {
  private static final Texts TEXTS = Texts.of(FormFieldTexts.class);

  private FormFieldTexts() {}

  /** The text of a key of {@code texts/kit.form.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
