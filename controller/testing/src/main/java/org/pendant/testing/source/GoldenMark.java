package org.pendant.testing.source;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Golden mark: {@code # @golden [deg=0.1] [mm=0.5] [s=0.01]} above a test: it is compared with a
 * recording of itself.
 *
 * @param deg how far each joint may be from where it was, degrees; empty where only the TCP counts
 * @param mm how far the TCP may be from where it was; empty where only joints count
 * @param seconds by how much everything may come earlier or later, at most 5
 */
public record GoldenMark(OptionalDouble deg, OptionalDouble mm, double seconds) {
  private static final double STANDARD_DEG = 0.1;
  private static final double STANDARD_S = 0.01;

  /** What comes still later is looked for in too many frames. */
  private static final double MAX_S = 5;

  private static final Pattern PART = Pattern.compile("(deg|mm|s)=(\\d+(?:\\.\\d*)?|\\.\\d+)");

  /** Reads what stands behind the word; empty where it is none of these. */
  static Optional<GoldenMark> of(String text) {
    OptionalDouble deg = OptionalDouble.empty();
    OptionalDouble mm = OptionalDouble.empty();
    double seconds = STANDARD_S;
    for (String each : text.isBlank() ? new String[0] : text.strip().split("[,\\s]+", -1)) {
      Matcher part = PART.matcher(each);
      if (!part.matches()) {
        return Optional.empty();
      }
      double number = Double.parseDouble(part.group(2));
      switch (part.group(1)) {
        case "deg" -> deg = OptionalDouble.of(number);
        case "mm" -> mm = OptionalDouble.of(number);
        default -> seconds = number;
      }
    }
    if (deg.isEmpty() && mm.isEmpty()) {
      deg = OptionalDouble.of(STANDARD_DEG);
    }
    return seconds <= MAX_S ? Optional.of(new GoldenMark(deg, mm, seconds)) : Optional.empty();
  }
}
