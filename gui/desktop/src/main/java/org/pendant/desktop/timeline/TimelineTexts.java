package org.pendant.desktop.timeline;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class TimelineTexts {
  private static final Texts TEXTS = Texts.of(TimelineTexts.class, Messages::shown);

  private TimelineTexts() {}

  /** The text of a key of {@code texts/desktop.timeline.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
