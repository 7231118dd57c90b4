package org.pendant.desktop.ports;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class PortsTexts {
  private static final Texts TEXTS = Texts.of(PortsTexts.class, Messages::shown);

  private PortsTexts() {}

  /** The text of a key of {@code texts/desktop.ports.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
