package org.pendant.desktop.plot;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class PlotTexts {
  private static final Texts TEXTS = Texts.of(PlotTexts.class, Messages::shown);

  private PlotTexts() {}

  /** The text of a key of {@code texts/desktop.plot.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
