package org.pendant.kit.action;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/**
 * Fuzzy match: whether the letters of a query occur in a text in their order, and how well: letters
 * at the start of words and letters in a row count more.
 *
 * @param score higher is better
 */
public record FuzzyMatch(int score) {
  private static final int FOUND = 1;
  private static final int IN_A_ROW = 8;
  private static final int WORD_BEGIN = 6;
  private static final int TEXT_BEGIN = 9;
  private static final int PLACES = 3;

  static Optional<FuzzyMatch> of(String query, String text) {
    String wanted = query.toLowerCase(Locale.ROOT).replace(" ", "");
    String lower = text.toLowerCase(Locale.ROOT);
    int best = best(wanted, 0, lower, 0, false);
    return best == Integer.MIN_VALUE ? Optional.empty() : Optional.of(new FuzzyMatch(best));
  }

  /** The best score of the query from {@code q} on in the text from {@code t} on. */
  private static int best(String query, int q, String text, int t, boolean row) {
    if (q == query.length()) {
      return -text.length() / 8;
    }
    int best = Integer.MIN_VALUE;
    int place = text.indexOf(query.charAt(q), t);
    // The first few places are enough: texts are short, and this keeps the search small.
    for (int tries = 0; place >= 0 && tries < PLACES; tries++) {
      int rest = best(query, q + 1, text, place + 1, true);
      if (rest != Integer.MIN_VALUE) {
        int begin = place == 0 ? TEXT_BEGIN : beginsWord(text, place) ? WORD_BEGIN : 0;
        best = Math.max(best, rest + FOUND + begin + (row && place == t ? IN_A_ROW : 0));
      }
      place = text.indexOf(query.charAt(q), place + 1);
    }
    return best;
  }

  private static boolean beginsWord(String text, int index) {
    return index == 0 || !Character.isLetterOrDigit(text.charAt(index - 1));
  }

  /** Those that match, best first; all in their order for an empty query. */
  public static <T> List<T> filter(String query, List<T> all, Function<T, String> textOf) {
    record Found<T>(T item, int score) {}
    return all.stream()
        .flatMap(
            item -> of(query, textOf.apply(item)).map(m -> new Found<>(item, m.score())).stream())
        .sorted(Comparator.comparingInt((Found<T> found) -> query.isBlank() ? 0 : -found.score()))
        .map(Found::item)
        .toList();
  }
}
