package org.pendant.desktop.shell.run;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class RunTexts {
  private static final Texts TEXTS = Texts.of(RunTexts.class, Messages::shown);

  private RunTexts() {}

  /** The text of a key of {@code texts/desktop.shell.run.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
