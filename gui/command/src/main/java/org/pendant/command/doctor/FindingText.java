package org.pendant.command.doctor;

import org.pendant.command.text.CommandLanguage;
import org.pendant.text.Language;

/**
 * Finding text: what a finding says, once for reports, which others read, and once for people.
 *
 * @param english in English
 * @param shown in the language of commands
 */
public record FindingText(String english, String shown) {
  static final FindingText NONE = of("");

  /** What reads the same in every language, such as a name or a version. */
  public static FindingText of(String text) {
    return new FindingText(text, text);
  }

  /** What others have said in English, such as why a file cannot be read. */
  public static FindingText message(String english) {
    return new FindingText(english, CommandLanguage.shown(english));
  }

  /** How many there are of something, in groups of three digits. */
  public static FindingText count(long count) {
    return new FindingText(Language.ENGLISH.grouped(count), CommandLanguage.grouped(count));
  }
}
