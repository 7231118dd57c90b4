package org.pendant.spark;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SparkTexts {
  private static final Texts TEXTS = Texts.english(SparkTexts.class);

  private SparkTexts() {}

  /** The text of a key of {@code texts/spark.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
