package org.pendant.desktop.whatif;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class WhatIfTexts {
  private static final Texts TEXTS = Texts.of(WhatIfTexts.class, Messages::shown);

  private WhatIfTexts() {}

  /** The text of a key of {@code texts/desktop.whatif.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
