package org.pendant.desktop.workbench;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class WorkbenchTexts {
  private static final Texts TEXTS = Texts.of(WorkbenchTexts.class, Messages::shown);

  private WorkbenchTexts() {}

  /** The text of a key of {@code texts/desktop.workbench.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
