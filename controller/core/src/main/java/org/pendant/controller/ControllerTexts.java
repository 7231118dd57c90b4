package org.pendant.controller;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ControllerTexts {
  private static final Texts TEXTS = Texts.english(ControllerTexts.class);

  private ControllerTexts() {}

  /** The text of a key of {@code texts/controller.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
