package org.pendant.models.kinematics;

import org.pendant.text.Texts;

/** What this package says to people. */
final class KinematicsTexts {
  private static final Texts TEXTS = Texts.english(KinematicsTexts.class);

  private KinematicsTexts() {}

  /** The text of a key of {@code texts/models.kinematics.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
