package org.pendant.desktop.ports;

import java.util.function.BinaryOperator;
import org.pendant.kit.text.Messages;
import org.pendant.protocols.wire.Reading;

/** Message words: what messages say, in the language of the window; what peers wrote stays. */
final class MessageWords {
  private MessageWords() {}

  /** What a message does, or what it says if it does nothing. */
  static String line(Reading reading) {
    return shown(reading, reading.effect().orElse(reading.summary()));
  }

  /** What a message says. */
  static String summary(Reading reading) {
    return shown(reading, reading.summary());
  }

  /** Something that is said of a message. */
  static String shown(Reading reading, String said) {
    return shown(reading, said, Messages::shown);
  }

  /**
   * The same.
   *
   * @param translate a text, in which the second one stays as it is
   */
  static String shown(Reading reading, String said, BinaryOperator<String> translate) {
    return translate.apply(said, reading.quoted() ? reading.summary() : "");
  }
}
