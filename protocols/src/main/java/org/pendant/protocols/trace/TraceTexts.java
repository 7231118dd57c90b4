package org.pendant.protocols.trace;

import org.pendant.text.Texts;

/** What this package says to people. */
final class TraceTexts {
  private static final Texts TEXTS = Texts.english(TraceTexts.class);

  private TraceTexts() {}

  /** The text of a key of {@code texts/protocols.trace.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
