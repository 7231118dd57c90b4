package org.pendant.desktop.plot;

import java.util.List;

/** Legend: what the lines of a chart are called beside each other. */
final class Legend {
  private static final String COMMA = ", ";

  private Legend() {}

  /**
   * What all names begin with, which need not stand in each of them, such as {@code Actual
   * position}; empty where they have nothing in common, or where there is one name only.
   */
  static String common(List<String> names) {
    if (names.size() < 2) {
      return "";
    }
    int end = names.getFirst().lastIndexOf(COMMA);
    String start = end < 0 ? "" : names.getFirst().substring(0, end);
    return names.stream().allMatch(each -> each.startsWith(start + COMMA)) ? start : "";
  }

  /** The name of a line below what is common to all. */
  static String below(String common, String name) {
    return !common.isEmpty() && name.startsWith(common + COMMA)
        ? name.substring(common.length() + COMMA.length())
        : name;
  }
}
