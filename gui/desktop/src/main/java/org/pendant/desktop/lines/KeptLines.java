package org.pendant.desktop.lines;

import java.util.Arrays;
import java.util.List;

/**
 * Kept lines: where the lines of a text are after it was edited, as long as they say the same;
 * blanks around them do not matter. Lines count from 1.
 */
public final class KeptLines {
  /** What is compared line by line at most; in more only lines that have not moved are found. */
  private static final int MAX_CELLS = 250_000;

  /** The present line of each, by the line that it was; 0 for those that are gone. */
  private final int[] now;

  private KeptLines(int[] now) {
    this.now = now;
  }

  /** From {@code old} to {@code next}. */
  public static KeptLines between(String old, String next) {
    List<String> before = old.lines().map(String::strip).toList();
    List<String> after = next.lines().map(String::strip).toList();
    int[] now = new int[before.size() + 1];
    int most = Math.min(before.size(), after.size());
    int start = 0;
    while (start < most && before.get(start).equals(after.get(start))) {
      now[start + 1] = start + 1;
      start++;
    }
    int end = 0;
    while (end < most - start
        && before.get(before.size() - 1 - end).equals(after.get(after.size() - 1 - end))) {
      now[before.size() - end] = after.size() - end;
      end++;
    }
    match(
        before.subList(start, before.size() - end),
        after.subList(start, after.size() - end),
        start,
        now);
    return new KeptLines(now);
  }

  /** The longest common subsequence of what is different (Wagner and Fischer, 1974). */
  private static void match(List<String> before, List<String> after, int start, int[] now) {
    if ((long) before.size() * after.size() > MAX_CELLS) {
      for (int i = 0; i < Math.min(before.size(), after.size()); i++) {
        now[start + i + 1] = before.get(i).equals(after.get(i)) ? start + i + 1 : 0;
      }
      return;
    }
    int[][] common = new int[before.size() + 1][after.size() + 1];
    for (int i = before.size() - 1; i >= 0; i--) {
      for (int j = after.size() - 1; j >= 0; j--) {
        common[i][j] =
            before.get(i).equals(after.get(j))
                ? common[i + 1][j + 1] + 1
                : Math.max(common[i + 1][j], common[i][j + 1]);
      }
    }
    int i = 0;
    int j = 0;
    while (i < before.size() && j < after.size()) {
      if (before.get(i).equals(after.get(j))) {
        now[start + i + 1] = start + j + 1;
        i++;
        j++;
      } else if (common[i + 1][j] >= common[i][j + 1]) {
        i++;
      } else {
        j++;
      }
    }
  }

  /** Where a line is now; 0 if it is gone or says something else. */
  public int now(int old) {
    return old >= 1 && old < now.length ? now[old] : 0;
  }

  @Override
  public String toString() {
    return Arrays.toString(now);
  }
}
