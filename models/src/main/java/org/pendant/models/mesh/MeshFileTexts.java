package org.pendant.models.mesh;

import org.pendant.text.Texts;

/** What this package says to people. */
final class MeshFileTexts {
  private static final Texts TEXTS = Texts.english(MeshFileTexts.class);

  private MeshFileTexts() {}

  /** The text of a key of {@code texts/models.mesh.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
