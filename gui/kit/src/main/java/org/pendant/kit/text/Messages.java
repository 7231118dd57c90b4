package org.pendant.kit.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.text.Language;
import org.pendant.text.Translations;

/**
 * What is said below the window, in the language of the window: lines of a log, why something was
 * refused, labels of what there is. All of that is English until it is shown. What people have
 * written themselves is not shown by this. The program lists the bundles that such messages are
 * made from in its resource {@code texts/bundles.txt}.
 */
public final class Messages {
  /** Messages whose translation is remembered, since what is painted asks again and again. */
  private static final int MAX_REMEMBERED = 4096;

  /** Stands for what people have written; a character that no text has. */
  private static final String WRITTEN = "\uE000";

  private static final boolean ENGLISH = Language.ofProcess() == Language.ENGLISH;
  private static final Map<String, String> REMEMBERED = new ConcurrentHashMap<>();

  private Messages() {}

  /** A message as people read it. Any thread may ask. */
  public static String shown(String message) {
    if (ENGLISH) {
      return message;
    }
    String known = REMEMBERED.get(message);
    if (known == null) {
      if (REMEMBERED.size() >= MAX_REMEMBERED) {
        REMEMBERED.clear();
      }
      known = Loaded.TRANSLATIONS.of(message);
      REMEMBERED.put(message, known);
    }
    return known;
  }

  /**
   * A message with something that people have written: words of that are none of the message's, as
   * in the call of a subprogram {@code Open gripper}. Any thread may ask.
   *
   * @param written what stands in the message as it is; may be empty
   */
  public static String shown(String message, String written) {
    return written.isEmpty()
        ? shown(message)
        : shown(message.replace(written, WRITTEN)).replace(WRITTEN, written);
  }

  /** Names of the bundles that messages come from. */
  static List<String> bundles() {
    try (InputStream in = Messages.class.getResourceAsStream("/texts/bundles.txt")) {
      String list = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return list.lines().filter(line -> !line.startsWith("#")).toList();
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read the names of bundles", e);
    }
  }

  /** Read at the first message, which English windows never have. */
  private static final class Loaded {
    static final Translations TRANSLATIONS =
        Translations.of(Language.ofProcess(), Messages.class.getClassLoader(), bundles());
  }
}
