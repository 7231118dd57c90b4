package org.pendant.desktop.cell;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;

/** Shown range: what a file refuses in m, in the measure in which people have typed it. */
final class ShownRange {
  private static final String NUMBER = "(-?[0-9.]+(?:E-?[0-9]+)?)";
  private static final Pattern RANGE =
      Pattern.compile("is " + NUMBER + " m, must be " + NUMBER + " to " + NUMBER + " m$");

  private ShownRange() {}

  /** Such as {@code radius is 0 mm, must be 1 to 10000 mm}; what is no range of lengths stays. */
  static String of(String refusal, Measures measures) {
    Measure unit = measures.of(Measure.MILLIMETRE);
    return RANGE
        .matcher(refusal)
        .replaceFirst(
            parts ->
                Matcher.quoteReplacement(
                    "is %s, must be %s to %s"
                        .formatted(
                            unit.words(number(parts.group(1))),
                            unit.text(number(parts.group(2))),
                            unit.words(number(parts.group(3))))));
  }

  private static double number(String text) {
    return Double.parseDouble(text);
  }
}
