package org.pendant.language.service;

import java.util.Locale;

/** Matching: how well a name fits what is typed of it. */
enum Matching {
  /** The name begins with exactly that. */
  PREFIX,
  /** The name begins with that, but for the case of letters. */
  PREFIX_IN_OTHER_CASE,
  /** All letters occur in the name in this order, e.g. {@code gatp} in get_actual_tcp_pose. */
  SUBSEQUENCE,
  NONE;

  static Matching of(String typed, String name) {
    if (name.startsWith(typed)) {
      return PREFIX;
    }
    String lowTyped = typed.toLowerCase(Locale.ROOT);
    String lowName = name.toLowerCase(Locale.ROOT);
    if (lowName.startsWith(lowTyped)) {
      return PREFIX_IN_OTHER_CASE;
    }
    int at = -1;
    for (int i = 0; i < lowTyped.length(); i++) {
      at = lowName.indexOf(lowTyped.charAt(i), at + 1);
      if (at < 0) {
        return NONE;
      }
    }
    return SUBSEQUENCE;
  }
}
