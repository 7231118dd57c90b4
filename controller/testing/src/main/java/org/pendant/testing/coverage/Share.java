package org.pendant.testing.coverage;

import java.util.Locale;
import java.util.function.Function;

/**
 * Share: how many of some places were reached.
 *
 * @param reached of {@code total}
 */
public record Share(int reached, int total) {
  /** Of nothing. */
  public static final Share NONE = new Share(0, 0);

  /** Those of both. */
  public Share plus(Share other) {
    return new Share(reached + other.reached, total + other.total);
  }

  /** Those of all {@code parts}. */
  static <T> Share of(Iterable<T> parts, Function<T, Share> share) {
    Share all = NONE;
    for (T part : parts) {
      all = all.plus(share.apply(part));
    }
    return all;
  }

  /** Between 0 and 1; 1 of nothing. */
  public double rate() {
    return total == 0 ? 1 : (double) reached / total;
  }

  /** Such as {@code 83.3 %}: 100 only when all were reached; {@code -} of nothing. */
  public String percent() {
    if (total == 0) {
      return "-";
    }
    return reached == total
        ? "100 %"
        : String.format(Locale.ROOT, "%.1f %%", Math.floor(1000.0 * reached / total) / 10);
  }
}
