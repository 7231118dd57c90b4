package org.pendant.text;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** A language in which everything is said. */
public enum Language {
  /** The one in which texts are written first. */
  ENGLISH("en", "English"),
  /** German. */
  GERMAN("de", "Deutsch"),
  /** Chinese, in simplified characters. */
  CHINESE("zh", "\u4e2d\u6587");

  /**
   * Environment variable with the code of the language that commands speak in place of English, and
   * the window in place of the system's.
   */
  public static final String VARIABLE = "PENDANT_LANGUAGE";

  private final String code;
  private final String title;

  Language(String code, String title) {
    this.code = code;
    this.title = title;
  }

  /** Its code in ISO 639, such as {@code de}. */
  public String code() {
    return code;
  }

  /** What it is called in itself. */
  public String title() {
    return title;
  }

  /**
   * A title as it reads within a sentence: with a small letter in English, unless it begins with an
   * abbreviation; as it is where nouns keep theirs, or letters have no case.
   */
  public String withinSentence(String title) {
    boolean abbreviation = title.length() > 1 && Character.isUpperCase(title.charAt(1));
    return this != ENGLISH || title.isEmpty() || abbreviation
        ? title
        : title.substring(0, 1).toLowerCase(Locale.ROOT) + title.substring(1);
  }

  /** Words one after the other, with commas between. */
  public String joined(List<String> words) {
    return String.join(this == CHINESE ? "\uff0c" : ", ", words);
  }

  /** What is told of something, behind its name and a colon. */
  public String told(String name, String what) {
    return name + (this == CHINESE ? "\uff1a" : ": ") + what;
  }

  /**
   * How many there are of something, in groups of three digits. In German with narrow spaces: the
   * point that is usual there is before the decimals of the numbers around it, as in scripts.
   */
  public String grouped(long count) {
    String english = String.format(Locale.ROOT, "%,d", count);
    return this == GERMAN ? english.replace(',', '\u202f') : english;
  }

  /** The one that has a code; empty if none has. */
  public static Optional<Language> ofCode(String code) {
    for (Language each : values()) {
      if (each.code.equals(code)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  /**
   * The one that is asked for by {@link #VARIABLE}; empty if none is, or one that is not spoken
   * here.
   */
  public static Optional<Language> askedFor(Map<String, String> environment) {
    return ofCode(environment.getOrDefault(VARIABLE, ""));
  }

  /** That of a locale; English for one that is not spoken here. */
  public static Language of(Locale locale) {
    return ofCode(locale.getLanguage()).orElse(ENGLISH);
  }

  /**
   * That of the process: of the locale for what is displayed, {@link Locale.Category#DISPLAY},
   * which is the system's unless somebody chose another. How numbers read does not depend on it.
   */
  public static Language ofProcess() {
    return of(Locale.getDefault(Locale.Category.DISPLAY));
  }
}
