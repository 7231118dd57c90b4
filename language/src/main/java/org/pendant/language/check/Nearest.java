package org.pendant.language.check;

import java.util.Collection;
import java.util.Optional;
import java.util.function.Supplier;

/** Nearest name: finds the name that was probably meant. */
public final class Nearest {
  /** Suggestions cost a look at every name; a file with more unknown names has another problem. */
  private static final int LIMIT = 50;

  private int asked;

  /** The nearest of a few candidates, for a caller who asks once. */
  public static Optional<String> among(String name, Collection<String> candidates) {
    return new Nearest().to(name, () -> candidates);
  }

  /** The candidate fewest typing slips away from {@code name}, if one is near. */
  public Optional<String> to(String name, Supplier<? extends Collection<String>> names) {
    if (asked++ >= LIMIT) {
      return Optional.empty();
    }
    Collection<String> candidates = names.get();
    int best = Math.max(1, name.length() / 3) + 1;
    Optional<String> nearest = Optional.empty();
    for (String candidate : candidates) {
      if (candidate.equalsIgnoreCase(name) && best > 1 && !candidate.equals(name)) {
        best = 1;
        nearest = Optional.of(candidate);
      } else if (Math.abs(candidate.length() - name.length()) < best) {
        int slips = slips(name, candidate);
        if (slips < best && slips < Math.max(name.length(), candidate.length())) {
          best = slips;
          nearest = Optional.of(candidate);
        }
      }
    }
    return nearest;
  }

  /** Letters to insert, drop, change or swap with their neighbour. */
  private static int slips(String from, String to) {
    int[] beforeLast = new int[to.length() + 1];
    int[] last = new int[to.length() + 1];
    int[] row = new int[to.length() + 1];
    for (int j = 0; j <= to.length(); j++) {
      last[j] = j;
    }
    for (int i = 1; i <= from.length(); i++) {
      row[0] = i;
      for (int j = 1; j <= to.length(); j++) {
        char a = from.charAt(i - 1);
        char b = to.charAt(j - 1);
        int changed = last[j - 1] + (a == b ? 0 : 1);
        row[j] = Math.min(changed, Math.min(last[j], row[j - 1]) + 1);
        if (i > 1 && j > 1 && a == to.charAt(j - 2) && b == from.charAt(i - 2)) {
          row[j] = Math.min(row[j], beforeLast[j - 2] + 1);
        }
      }
      int[] oldest = beforeLast;
      beforeLast = last;
      last = row;
      row = oldest;
    }
    return last[to.length()];
  }
}
