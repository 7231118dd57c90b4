package org.pendant.models.text;

import java.math.BigDecimal;
import java.math.RoundingMode;
import org.pendant.models.pose.Pose;

/**
 * Text of numbers: how numbers and poses print (manual 16.57, 16.65): as C's {@code %f} does, with
 * six decimals rounded to nearest from the exact binary value, then without trailing zeros and
 * without a bare point. The manual leaves the sign of zero open; here a value that rounds to zero
 * prints as {@code 0}.
 */
public final class FloatText {
  private static final int DECIMALS = 6;
  private static final double SCALE = 1e6;
  private static final long SCALE_LONG = 1_000_000;
  private static final int WHOLE_NS = 12;
  private static final int FRACTION_NS = 35;
  private static final int EXACT_NS = 1500;

  /** Below this magnitude a scaled value is so precise that most roundings can be decided on it. */
  private static final double FAST_LIMIT = 1e9;

  private FloatText() {}

  /** The text of a float. */
  public static String of(double number) {
    StringBuilder text = new StringBuilder(16);
    append(text, number);
    return text.toString();
  }

  /** The text of a pose, {@code p[x, y, z, rx, ry, rz]} in m and rad. */
  public static String of(Pose pose) {
    StringBuilder text = new StringBuilder(64).append("p[");
    double[] numbers = pose.toArray();
    for (int i = 0; i < numbers.length; i++) {
      append(i == 0 ? text : text.append(", "), numbers[i]);
    }
    return text.append(']').toString();
  }

  /**
   * Adds the text of a float.
   *
   * @return how long that takes, in nanoseconds, roughly
   */
  public static int append(StringBuilder text, double number) {
    if (number == (long) number && Math.abs(number) < FAST_LIMIT) {
      text.append((long) number);
      return WHOLE_NS;
    }
    double scaled = Math.abs(number) * SCALE;
    double fraction = scaled - Math.floor(scaled);
    // the product is off by half a unit in its last place at most: only nearer to a tie than
    // that can the exact value round the other way
    if (Math.abs(number) < FAST_LIMIT && Math.abs(fraction - 0.5) > Math.ulp(scaled)) {
      appendScaled(text, number < 0, (long) Math.rint(scaled));
      return FRACTION_NS;
    }
    if (Double.isNaN(number)) {
      text.append("nan");
    } else if (Double.isInfinite(number)) {
      text.append(number < 0 ? "-inf" : "inf");
    } else {
      appendExact(text, number);
    }
    return EXACT_NS;
  }

  private static void appendScaled(StringBuilder text, boolean negative, long scaled) {
    if (negative && scaled != 0) {
      text.append('-');
    }
    text.append(scaled / SCALE_LONG);
    long decimals = scaled % SCALE_LONG;
    if (decimals != 0) {
      text.append('.');
      for (long place = SCALE_LONG / 10; decimals != 0; place /= 10) {
        text.append((char) ('0' + decimals / place));
        decimals %= place;
      }
    }
  }

  private static void appendExact(StringBuilder text, double number) {
    BigDecimal rounded = new BigDecimal(number).setScale(DECIMALS, RoundingMode.HALF_EVEN);
    text.append(rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString());
  }
}
