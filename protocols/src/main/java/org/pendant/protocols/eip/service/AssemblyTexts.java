package org.pendant.protocols.eip.service;

import org.pendant.text.Texts;

/** What this package says to people. */
final class AssemblyTexts {
  private static final Texts TEXTS = Texts.english(AssemblyTexts.class);

  private AssemblyTexts() {}

  /** The text of a key of {@code texts/protocols.eip.service.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
