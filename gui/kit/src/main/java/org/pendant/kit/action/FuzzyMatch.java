package org.pendant.kit.action;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Fuzzy match: whether each word of a query is found in a text, as letters in a row or as letters
 * in a row at the begins of several of its words, and how well: begins and rows count more.
 *
 * @param asTyped whether words of the text begin with what was typed, not only with single letters
 *     of it
 * @param score higher is better
 */
public record FuzzyMatch(boolean asTyped, int score) {
  private static final int FOUND = 1;
  private static final int IN_A_ROW = 8;
  private static final int WORD_BEGIN = 6;
  private static final int TEXT_BEGIN = 9;
  private static final int WHOLE = 12;
  private static final int NONE = Integer.MIN_VALUE;

  static Optional<FuzzyMatch> of(String query, String text) {
    String wanted = query.strip().toLowerCase(Locale.ROOT);
    String lower = text.toLowerCase(Locale.ROOT);
    int score = lower.contains(wanted) ? WHOLE : 0;
    boolean asTyped = true;
    for (String word : wanted.split("\\s+", -1)) {
      int best = Math.max(row(word, lower), new Begins(word, lower).best(0, 0));
      if (best == NONE) {
        return Optional.empty();
      }
      score += best;
      asTyped &= beginsOne(word, lower);
    }
    return Optional.of(new FuzzyMatch(asTyped, score - text.length() / 8));
  }

  /** All letters in a row, anywhere; a single one says too little inside of a word. */
  private static int row(String word, String text) {
    int best = NONE;
    if (word.length() > 1) {
      for (int at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
        best = Math.max(best, inRow(text, at, word.length()));
      }
    }
    return best;
  }

  private static int inRow(String text, int at, int length) {
    int begin = at == 0 ? TEXT_BEGIN : beginsWord(text, at) ? WORD_BEGIN : 0;
    return begin + length * FOUND + (length - 1) * IN_A_ROW;
  }

  /** Whether a word of the text begins with this one. */
  private static boolean beginsOne(String word, String text) {
    int at = text.indexOf(word);
    while (at >= 0 && !beginsWord(text, at)) {
      at = text.indexOf(word, at + 1);
    }
    return at >= 0;
  }

  private static boolean beginsWord(String text, int index) {
    return index == 0 || !Character.isLetterOrDigit(text.charAt(index - 1));
  }

  /** Letters that go on at the begins of later words, as {@code rupr} for {@code Run program}. */
  private static final class Begins {
    private final String word;
    private final String text;
    private final Map<Integer, Integer> known = new HashMap<>();

    Begins(String word, String text) {
      this.word = word;
      this.text = text;
    }

    /** The best score of the letters from {@code letter} on in the text from {@code from} on. */
    int best(int letter, int from) {
      if (letter == word.length()) {
        return 0;
      }
      int place = letter * (text.length() + 1) + from;
      Integer before = known.get(place);
      if (before != null) {
        return before;
      }
      int best = NONE;
      for (int at = from; at < text.length(); at++) {
        if (beginsWord(text, at)) {
          best = Math.max(best, bestAt(letter, at));
        }
      }
      known.put(place, best);
      return best;
    }

    /** As {@link #best}, with a row that begins at a place. */
    private int bestAt(int letter, int at) {
      int best = NONE;
      int length = 0;
      while (letter + length < word.length()
          && at + length < text.length()
          && word.charAt(letter + length) == text.charAt(at + length)) {
        length++;
        int rest = best(letter + length, at + length);
        if (rest != NONE) {
          best = Math.max(best, rest + inRow(text, at, length));
        }
      }
      return best;
    }
  }

  /** Those that match, best first; all in their order for an empty query. */
  public static <T> List<T> filter(String query, List<T> all, Function<T, String> textOf) {
    return filter(query, all, textOf, item -> true);
  }

  /**
   * As {@link #filter(String, List, Function)}, but those that can be {@code used} come before
   * those that cannot, unless only these have words that begin as typed.
   */
  public static <T> List<T> filter(
      String query, List<T> all, Function<T, String> textOf, Predicate<T> used) {
    record Found<T>(T item, FuzzyMatch match, boolean usable) {}
    Comparator<Found<T>> usable = Comparator.comparing(found -> !found.usable());
    Comparator<Found<T>> best =
        Comparator.comparing((Found<T> found) -> !found.match().asTyped())
            .thenComparing(usable)
            .thenComparing(found -> -found.match().score());
    return all.stream()
        .flatMap(
            item ->
                of(query, textOf.apply(item)).stream()
                    .map(match -> new Found<>(item, match, used.test(item))))
        .sorted(query.isBlank() ? usable : best)
        .map(Found::item)
        .toList();
  }
}
