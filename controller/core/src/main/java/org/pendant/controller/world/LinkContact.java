package org.pendant.controller.world;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** Link contact: what becomes of a link of the arm that gets into something. */
public enum LinkContact {
  /** A protective stop. */
  STOP,
  /** Nothing: links pass through all there is. */
  PASS;

  /** The word in files. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The one with this word. */
  static Optional<LinkContact> of(String word) {
    return Arrays.stream(values()).filter(each -> each.word().equals(word)).findFirst();
  }
}
