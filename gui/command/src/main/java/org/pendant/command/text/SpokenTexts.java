package org.pendant.command.text;

import org.pendant.text.Language;
import org.pendant.text.Texts;

/**
 * Spoken texts: what a package of commands says, in the language of the command line, or in that of
 * an editor which a command listens to.
 */
public final class SpokenTexts {
  private final Class<?> owner;
  private final Texts own;

  /** What the package of {@code owner} says. */
  public SpokenTexts(Class<?> owner) {
    this.owner = owner;
    own = CommandLanguage.texts(owner);
  }

  /**
   * The text of a key.
   *
   * @param values what stands for {@code {0}}, {@code {1}} and so on
   */
  public String get(String key, Object... values) {
    return CommandLanguage.ofEditor()
        .map(language -> of(language).get(key, values))
        .orElseGet(() -> own.get(key, values));
  }

  private Texts of(Language language) {
    return Texts.of(owner, language, CommandLanguage::shown);
  }
}
