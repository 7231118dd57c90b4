package org.pendant.desktop.log;

/**
 * Text search: what people look for in the messages, upper and lower case alike.
 *
 * @param wanted empty for nothing
 */
record TextSearch(String wanted) {
  /** Looks for nothing. */
  static final TextSearch NONE = new TextSearch("");

  boolean empty() {
    return wanted.isEmpty();
  }

  /** Where {@code text} has it at or after {@code from}, or -1. */
  int find(String text, int from) {
    if (wanted.isEmpty()) {
      return -1;
    }
    // most places differ in their first character already
    char upper = Character.toUpperCase(wanted.charAt(0));
    char lower = Character.toLowerCase(upper);
    for (int i = from; i <= text.length() - wanted.length(); i++) {
      char c = text.charAt(i);
      boolean begins = c == upper || c == lower || (c > 127 && Character.toUpperCase(c) == upper);
      if (begins && text.regionMatches(true, i, wanted, 0, wanted.length())) {
        return i;
      }
    }
    return -1;
  }

  boolean in(String text) {
    return find(text, 0) >= 0;
  }
}
