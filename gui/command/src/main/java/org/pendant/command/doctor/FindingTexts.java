package org.pendant.command.doctor;

import java.util.Arrays;
import java.util.function.Function;
import org.pendant.command.text.CommandLanguage;
import org.pendant.text.Language;
import org.pendant.text.Texts;

/** Finding texts: what a package says in findings, in English and in the language of commands. */
public final class FindingTexts {
  private final Texts english;
  private final Texts shown;

  private FindingTexts(Texts english, Texts shown) {
    this.english = english;
    this.shown = shown;
  }

  /** What the package of {@code owner} says. */
  public static FindingTexts of(Class<?> owner) {
    return new FindingTexts(Texts.of(owner, Language.ENGLISH), CommandLanguage.texts(owner));
  }

  /**
   * The text of a key.
   *
   * @param values what stands for {@code {0}} and so on; of a {@link FindingText} what it says in
   *     the language of the text
   */
  public FindingText get(String key, Object... values) {
    return new FindingText(
        english.get(key, each(values, FindingText::english)),
        shown.get(key, each(values, FindingText::shown)));
  }

  private static Object[] each(Object[] values, Function<FindingText, String> form) {
    return Arrays.stream(values)
        .map(value -> value instanceof FindingText text ? form.apply(text) : value)
        .toArray();
  }
}
