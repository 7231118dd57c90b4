package org.pendant.gui.log;

/**
 * What people look for in the messages, upper and lower case alike.
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
    for (int i = from; i <= text.length() - wanted.length(); i++) {
      if (text.regionMatches(true, i, wanted, 0, wanted.length())) {
        return i;
      }
    }
    return -1;
  }

  boolean in(String text) {
    return find(text, 0) >= 0;
  }
}
