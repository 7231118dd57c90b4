package org.pendant.command.rpc;

import org.pendant.text.Texts;

/** What this package says to people. */
final class RpcTexts {
  private static final Texts TEXTS = Texts.english(RpcTexts.class);

  private RpcTexts() {}

  /** The text of a key of {@code texts/command.rpc.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
