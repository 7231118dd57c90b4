package org.pendant.controller.builtin;

/**
 * String search: finds a text in another one in a time that grows with their lengths, and not with
 * the product: the algorithm of Knuth, Morris and Pratt (Fast Pattern Matching in Strings, 1977).
 */
final class StringSearch {
  /** What is found as fast by trying all places. */
  private static final int SHORT = 16;

  private StringSearch() {}

  /** The first place in {@code text}, from {@code start} on, where {@code target} stands, or -1. */
  static int find(String text, String target, int start) {
    if (target.length() <= SHORT) {
      return text.indexOf(target, start);
    }
    int[] borders = borders(target);
    int matched = 0;
    for (int i = start; i < text.length(); i++) {
      while (matched > 0 && text.charAt(i) != target.charAt(matched)) {
        matched = borders[matched - 1];
      }
      if (text.charAt(i) == target.charAt(matched)) {
        matched++;
      }
      if (matched == target.length()) {
        return i - matched + 1;
      }
    }
    return -1;
  }

  /** For each beginning of {@code target}, how much of its end the target begins with as well. */
  private static int[] borders(String target) {
    int[] borders = new int[target.length()];
    int matched = 0;
    for (int i = 1; i < borders.length; i++) {
      while (matched > 0 && target.charAt(i) != target.charAt(matched)) {
        matched = borders[matched - 1];
      }
      if (target.charAt(i) == target.charAt(matched)) {
        matched++;
      }
      borders[i] = matched;
    }
    return borders;
  }
}
