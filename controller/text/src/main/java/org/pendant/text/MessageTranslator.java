package org.pendant.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Says in one language what others have said in English: lines of a log, why something was refused,
 * labels of what there is. The program lists the bundles that such messages are made from in its
 * resource {@code texts/bundles.txt}; they are read at the first message. Any thread may ask.
 */
public final class MessageTranslator {
  /** Messages whose translation is remembered, since what is painted asks again and again. */
  private static final int MAX_REMEMBERED = 4096;

  /** Stands for what people have written; a character that no text has. */
  private static final String WRITTEN = "\uE000";

  private final Language language;
  private final String own;
  private final Map<String, String> remembered = new ConcurrentHashMap<>();
  private Translations translations;

  /** Into a language; into English, which reads no bundle and leaves everything as it is, too. */
  public MessageTranslator(Language language) {
    this(language, "");
  }

  /**
   * The same, for who says something that others say as well, and means something else.
   *
   * @param own how the names of the bundles begin that it says it from, such as {@code editors.}
   */
  public MessageTranslator(Language language, String own) {
    this.language = language;
    this.own = own;
  }

  /** The language into which it translates. */
  public Language language() {
    return language;
  }

  /** A message as people read it. */
  public String shown(String message) {
    // one that is too long to be looked at is too long to be remembered
    if (language == Language.ENGLISH || message.length() > Translations.MAX_LENGTH) {
      return message;
    }
    String known = remembered.get(message);
    if (known == null) {
      if (remembered.size() >= MAX_REMEMBERED) {
        remembered.clear();
      }
      known = translations().of(message);
      remembered.put(message, known);
    }
    return known;
  }

  /**
   * A message with something that people have written: words of that are none of the message's, as
   * in the call of a subprogram {@code Open gripper}.
   *
   * @param written what stands in the message as it is; may be empty
   */
  public String shown(String message, String written) {
    return written.isEmpty()
        ? shown(message)
        : shown(message.replace(written, WRITTEN)).replace(WRITTEN, written);
  }

  private synchronized Translations translations() {
    if (translations == null) {
      List<String> bundles =
          bundles().stream().sorted(Comparator.comparing(each -> !each.startsWith(own))).toList();
      translations = Translations.of(language, MessageTranslator.class.getClassLoader(), bundles);
    }
    return translations;
  }

  /** Names of the bundles that messages come from. */
  private static List<String> bundles() {
    try (InputStream in = MessageTranslator.class.getResourceAsStream("/texts/bundles.txt")) {
      String list = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return list.lines().filter(line -> !line.startsWith("#")).toList();
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read the names of bundles", e);
    }
  }
}
