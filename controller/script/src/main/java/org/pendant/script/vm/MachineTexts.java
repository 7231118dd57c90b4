package org.pendant.script.vm;

import org.pendant.text.Texts;

/** What this package says to people. */
final class MachineTexts {
  private static final Texts TEXTS = Texts.english(MachineTexts.class);

  private MachineTexts() {}

  /** The text of a key of {@code texts/script.vm.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
