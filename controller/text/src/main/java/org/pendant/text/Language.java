package org.pendant.text;

import java.util.Locale;

/** A language in which everything is said. */
public enum Language {
  /** The one in which texts are written first. */
  ENGLISH("en", "English"),
  /** German. */
  GERMAN("de", "Deutsch"),
  /** Chinese, in simplified characters. */
  CHINESE("zh", "\u4e2d\u6587");

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

  /** That of a locale; English for one that is not spoken here. */
  public static Language of(Locale locale) {
    for (Language each : values()) {
      if (each.code.equals(locale.getLanguage())) {
        return each;
      }
    }
    return ENGLISH;
  }

  /**
   * That of the process: of the locale for what is displayed, {@link Locale.Category#DISPLAY},
   * which is the system's unless somebody chose another. How numbers read does not depend on it.
   */
  public static Language ofProcess() {
    return of(Locale.getDefault(Locale.Category.DISPLAY));
  }
}
