package org.pendant.command;

import java.util.function.UnaryOperator;
import org.pendant.command.text.CommandLanguage;
import org.pendant.text.Language;
import org.pendant.text.Texts;

/** What the usage texts say: read when they are printed, which no run does. */
final class UsageTexts {
  private static final String PART = "usage";

  private UsageTexts() {}

  /** In the language of the command line. */
  static Texts shown() {
    return CommandLanguage.texts(UsageTexts.class, PART);
  }

  /** For manual pages, completion and documentation, which are the same everywhere. */
  static Texts english() {
    return Texts.of(UsageTexts.class, PART, Language.ENGLISH, UnaryOperator.identity());
  }
}
