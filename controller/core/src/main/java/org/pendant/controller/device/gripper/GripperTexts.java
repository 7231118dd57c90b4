package org.pendant.controller.device.gripper;

import org.pendant.text.Texts;

/** What this package says to people. */
final class GripperTexts {
  private static final Texts TEXTS = Texts.english(GripperTexts.class);

  private GripperTexts() {}

  /**
   * The text of a key of {@code texts/controller.device.gripper.properties}, filled with values.
   */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
