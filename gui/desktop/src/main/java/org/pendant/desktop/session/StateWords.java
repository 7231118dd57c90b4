package org.pendant.desktop.session;

import java.util.Locale;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;

/** State words: modes and states as people read them. */
public final class StateWords {
  private StateWords() {}

  /** Such as {@code power off}. */
  public static String of(RobotMode mode) {
    return lower(mode);
  }

  /** Such as {@code protective stop}. */
  public static String of(SafetyMode mode) {
    return lower(mode);
  }

  private static String lower(Enum<?> word) {
    return word.name().replace('_', ' ').toLowerCase(Locale.ROOT);
  }

  /** With a capital letter at its start. */
  public static String capital(String words) {
    return words.isEmpty()
        ? words
        : words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
  }
}
