package org.pendant.desktop.debug;

/**
 * Line map: where the lines of a text are after it was edited: those before and after what is
 * different keep their place in the text, those between are taken for the nearest of what came
 * instead.
 *
 * @param before how many lines at the start are the same
 * @param oldLines how many the text had, at least 1
 * @param newLines how many it has now, at least 1
 * @param behind how many lines at the end are the same
 */
record LineMap(int before, int oldLines, int newLines, int behind) {

  /** From {@code old} to {@code now}, texts whose lines end with a line feed. */
  static LineMap between(String old, String now) {
    int oldLines = 1 + feeds(old, 0, old.length());
    if (old.equals(now)) {
      return new LineMap(oldLines, oldLines, oldLines, 0);
    }
    int most = Math.min(old.length(), now.length());
    int start = 0;
    while (start < most && old.charAt(start) == now.charAt(start)) {
      start++;
    }
    int end = 0;
    while (end < most - start
        && old.charAt(old.length() - 1 - end) == now.charAt(now.length() - 1 - end)) {
      end++;
    }
    int behind = feeds(old, old.length() - end, old.length());
    boolean whole = beginsLine(old, old.length() - end) && beginsLine(now, now.length() - end);
    return new LineMap(
        feeds(old, 0, start),
        oldLines,
        1 + feeds(now, 0, now.length()),
        whole ? behind + 1 : behind);
  }

  private static boolean beginsLine(String text, int offset) {
    return offset == 0 || text.charAt(offset - 1) == '\n';
  }

  private static int feeds(String text, int from, int to) {
    int feeds = 0;
    for (int i = from; i < to; i++) {
      if (text.charAt(i) == '\n') {
        feeds++;
      }
    }
    return feeds;
  }

  boolean unchanged() {
    return before == oldLines;
  }

  /** The present line of line {@code old}, both from 1; 0 stays 0. */
  int toNow(int old) {
    return moved(old, oldLines, newLines);
  }

  /** The line {@code now} in the text before, both from 1. */
  int toOld(int now) {
    return moved(now, newLines, oldLines);
  }

  private int moved(int line, int from, int to) {
    if (line <= before) {
      return line;
    }
    if (line > from - behind) {
      return line + to - from;
    }
    return Math.clamp(line, 1, Math.max(1, to - behind));
  }
}
