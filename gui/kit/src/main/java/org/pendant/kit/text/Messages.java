package org.pendant.kit.text;

import java.util.List;
import org.pendant.text.Language;
import org.pendant.text.MessageTranslator;

/**
 * What is said below the window, in the language of the window: lines of a log, why something was
 * refused, labels of what there is. All of that is English until it is shown. What people have
 * written themselves is not shown by this.
 */
public final class Messages {
  private static final MessageTranslator TRANSLATOR = new MessageTranslator(Language.ofProcess());

  private Messages() {}

  /** A message as people read it. Any thread may ask. */
  public static String shown(String message) {
    return TRANSLATOR.shown(message);
  }

  /**
   * A message with something that people have written: words of that are none of the message's, as
   * in the call of a subprogram {@code Open gripper}. Any thread may ask.
   *
   * @param written what stands in the message as it is; may be empty
   */
  public static String shown(String message, String written) {
    return TRANSLATOR.shown(message, written);
  }

  /** Words one after the other, with commas between. */
  public static String joined(List<String> words) {
    return Language.ofProcess().joined(words);
  }

  /**
   * What is told of something, behind its name and a colon, as the language of the window writes
   * it.
   */
  public static String told(String name, String what) {
    return Language.ofProcess().told(name, what);
  }
}
