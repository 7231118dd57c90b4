package org.pendant.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.MissingResourceException;
import java.util.Properties;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * What a package says to people, in one language. The texts are properties in UTF-8, in the folder
 * {@code texts} of the module's resources: those of {@code org.pendant.desktop.sweep} in {@code
 * desktop.sweep.properties} in English and {@code desktop.sweep_de.properties} in German. That
 * folder is no package: its files can be read from modules that open none.
 *
 * <p>{@code {0}} to {@code {9}} in a text stand for what the program puts there, as it reads as a
 * string; {@code {0*}} in a translation for what is an English text itself and must be translated
 * before. There is no other syntax: an apostrophe is one, and numbers stay as they are, which is
 * why this is not {@link java.text.MessageFormat}.
 */
public final class Texts {
  private static final String ROOT = "org.pendant.";

  private final String name;
  private final Map<String, String> texts;
  private final UnaryOperator<String> translate;
  private final Joining joining;

  private Texts(
      String name, Map<String, String> texts, UnaryOperator<String> translate, Joining joining) {
    this.name = name;
    this.texts = texts;
    this.translate = translate;
    this.joining = joining;
  }

  /**
   * What the package of {@code owner} says, in the {@linkplain Language#ofProcess() language of the
   * process}.
   */
  public static Texts of(Class<?> owner) {
    return of(owner, Language.ofProcess());
  }

  /**
   * The same, of a package that says what others have said in English.
   *
   * @param translate says that in the language of the process; asked for places {@code {0*}}
   */
  public static Texts of(Class<?> owner, UnaryOperator<String> translate) {
    return of(owner, Language.ofProcess(), translate);
  }

  /**
   * What the package of {@code owner} says in English: of a package whose messages go into logs,
   * files and out on ports, where they are the same everywhere. A window shows them by {@link
   * Translations}.
   */
  public static Texts english(Class<?> owner) {
    return of(owner, Language.ENGLISH);
  }

  /**
   * What the package of {@code owner} says, in a language; in English what was not translated.
   *
   * @throws MissingResourceException if it says nothing
   */
  public static Texts of(Class<?> owner, Language language) {
    return of(owner, language, UnaryOperator.identity());
  }

  /** The same, of a package that says what others have said in English. */
  public static Texts of(Class<?> owner, Language language, UnaryOperator<String> translate) {
    return of(owner.getPackageName().substring(ROOT.length()), owner, language, translate);
  }

  /**
   * What a part of a package says that is seldom read, which is in a bundle of its own.
   *
   * @param part its name, such as {@code usage} for {@code command.usage.properties}
   */
  public static Texts of(
      Class<?> owner, String part, Language language, UnaryOperator<String> translate) {
    String name = owner.getPackageName().substring(ROOT.length()) + "." + part;
    return of(name, owner, language, translate);
  }

  private static Texts of(
      String name, Class<?> owner, Language language, UnaryOperator<String> translate) {
    Map<String, String> texts = new HashMap<>();
    if (!read(owner, name, texts)) {
      throw new MissingResourceException("no texts of " + name, owner.getName(), "");
    }
    if (language != Language.ENGLISH) {
      read(owner, name + "_" + language.code(), texts);
    }
    return new Texts(name, texts, translate, Joining.of(language));
  }

  private static boolean read(Class<?> owner, String name, Map<String, String> into) {
    return read(name, file -> owner.getResourceAsStream('/' + file), into);
  }

  /**
   * Reads a bundle.
   *
   * @param files opens one by its name, or has null for one that is not there
   * @return whether there is such a bundle
   */
  static boolean read(String name, Function<String, InputStream> files, Map<String, String> into) {
    String[] compiled = CompiledTexts.of(name);
    for (int i = 0; i < compiled.length; i += 2) {
      into.put(compiled[i], compiled[i + 1]);
    }
    return compiled.length > 0 || readFile(name, files, into);
  }

  private static boolean readFile(
      String name, Function<String, InputStream> files, Map<String, String> into) {
    InputStream file = files.apply("texts/" + name + ".properties");
    if (file == null) {
      return false;
    }
    Properties texts = new Properties();
    try (Reader text = new InputStreamReader(file, StandardCharsets.UTF_8)) {
      texts.load(text);
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read the texts of " + name, e);
    }
    texts.stringPropertyNames().forEach(key -> into.put(key, texts.getProperty(key)));
    return true;
  }

  /**
   * The text of a key.
   *
   * @param values what stands for {@code {0}}, {@code {1}} and so on
   * @throws MissingResourceException if there is none
   */
  public String get(String key, Object... values) {
    String text = texts.get(key);
    if (text == null) {
      throw new MissingResourceException("no text " + key + " of " + name, name, key);
    }
    return values.length == 0 ? text : filled(text, values);
  }

  private String filled(String text, Object[] values) {
    StringBuilder filled = new StringBuilder(text.length() + 16 * values.length);
    int from = 0;
    for (int at = text.indexOf('{'); at >= 0; at = text.indexOf('{', from)) {
      int index = at + 2 < text.length() ? text.charAt(at + 1) - '0' : -1;
      boolean place = index >= 0 && index < values.length;
      boolean plain = place && text.startsWith("}", at + 2);
      boolean translated = place && text.startsWith("*}", at + 2);
      joining.append(filled, text.substring(from, plain || translated ? at : at + 1));
      if (plain) {
        joining.append(filled, String.valueOf(values[index]));
      } else if (translated) {
        joining.append(filled, translate.apply(String.valueOf(values[index])));
      }
      from = plain ? at + 3 : translated ? at + 4 : at + 1;
    }
    joining.append(filled, text.substring(from));
    return filled.toString();
  }
}
