package org.pendant.command.text;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.text.Language;
import org.pendant.text.MessageTranslator;
import org.pendant.text.Texts;

/**
 * What the command line says, in its language: the one that {@link Language#VARIABLE} asks for,
 * else English. What other programs read stays English whatever is asked for: recordings, tables,
 * reports, answers on ports, and what is generated from the commands, such as manual pages.
 */
public final class CommandLanguage {
  private static final Language LANGUAGE =
      Language.askedFor(System.getenv()).orElse(Language.ENGLISH);

  private static final MessageTranslator TRANSLATOR = new MessageTranslator(LANGUAGE);

  /** For an editor, which speaks another language perhaps. */
  private static final ScopedValue<MessageTranslator> EDITOR = ScopedValue.newInstance();

  private CommandLanguage() {}

  /** What the package of {@code owner} says. */
  public static Texts texts(Class<?> owner) {
    return Texts.of(owner, LANGUAGE, TRANSLATOR::shown);
  }

  /** What a part of the package of {@code owner} says, in a bundle of its own. */
  public static Texts texts(Class<?> owner, String part) {
    return Texts.of(owner, part, LANGUAGE, TRANSLATOR::shown);
  }

  /**
   * A message of others, such as why the controller has refused something: they all speak English.
   */
  public static String shown(String message) {
    return (EDITOR.isBound() ? EDITOR.get() : TRANSLATOR).shown(message);
  }

  /** How many there are of something, as {@link Language#grouped} writes it. */
  public static String grouped(long count) {
    return LANGUAGE.grouped(count);
  }

  /** Does something for an editor: what this thread says meanwhile it says in its language. */
  public static <R, X extends Throwable> R spoken(
      Language language, ScopedValue.CallableOp<R, X> work) throws X {
    return ScopedValue.where(EDITOR, new MessageTranslator(language)).call(work);
  }

  /** The language of the editor for which this thread does something now; empty for none. */
  static Optional<Language> ofEditor() {
    return EDITOR.isBound() ? Optional.of(EDITOR.get().language()) : Optional.empty();
  }

  /**
   * Has the process speak it, so that what the window's code says to a command is in it, too. The
   * window itself speaks the system's language where none is asked for.
   */
  public static void speak() {
    Locale.setDefault(Locale.Category.DISPLAY, Locale.of(LANGUAGE.code()));
  }

  /** Why an environment asks for a language in vain; empty if it does not. */
  public static Optional<String> refusal(Map<String, String> environment) {
    String asked = environment.getOrDefault(Language.VARIABLE, "");
    return asked.isEmpty() || Language.ofCode(asked).isPresent()
        ? Optional.empty()
        : Optional.of(
            Texts.of(CommandLanguage.class, LANGUAGE)
                .get("unknownLanguage", Language.VARIABLE, asked, codes()));
  }

  private static String codes() {
    return Arrays.stream(Language.values()).map(Language::code).collect(Collectors.joining(", "));
  }
}
