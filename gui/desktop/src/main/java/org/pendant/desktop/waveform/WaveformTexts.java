package org.pendant.desktop.waveform;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class WaveformTexts {
  private static final Texts TEXTS = Texts.of(WaveformTexts.class, Messages::shown);

  private WaveformTexts() {}

  /** The text of a key of {@code texts/desktop.waveform.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
