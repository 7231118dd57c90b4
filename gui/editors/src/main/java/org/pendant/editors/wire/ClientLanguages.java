package org.pendant.editors.wire;

import java.util.Locale;
import org.pendant.text.Language;
import org.pendant.text.MessageTranslator;

/**
 * Client languages: in which language a client is told what people read. Servers say all of it in
 * English, as the modules below them do, and translate it for the client that they send it to.
 */
public final class ClientLanguages {
  /** For clients that name no language: scripts and tests compare what they are told. */
  public static final MessageTranslator ENGLISH = new MessageTranslator(Language.ENGLISH);

  private ClientLanguages() {}

  /**
   * For a client that names its language.
   *
   * @param locale such as {@code de} or {@code zh-CN}; null for none
   */
  public static MessageTranslator of(String locale) {
    if (locale == null) {
      return ENGLISH;
    }
    Language language = Language.of(Locale.forLanguageTag(locale.replace('_', '-')));
    return language == Language.ENGLISH ? ENGLISH : new MessageTranslator(language, "editors.");
  }
}
