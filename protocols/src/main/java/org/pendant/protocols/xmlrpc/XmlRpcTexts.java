package org.pendant.protocols.xmlrpc;

import org.pendant.text.Texts;

/** What this package says to people. */
final class XmlRpcTexts {
  private static final Texts TEXTS = Texts.english(XmlRpcTexts.class);

  private XmlRpcTexts() {}

  /** The text of a key of {@code texts/protocols.xmlrpc.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
