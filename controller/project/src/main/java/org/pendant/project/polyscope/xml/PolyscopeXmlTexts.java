package org.pendant.project.polyscope.xml;

import org.pendant.text.Texts;

/** What this package says to people. */
final class PolyscopeXmlTexts {
  private static final Texts TEXTS = Texts.english(PolyscopeXmlTexts.class);

  private PolyscopeXmlTexts() {}

  /** The text of a key of {@code texts/project.polyscope.xml.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
