package org.pendant.desktop.testwriter;

import java.math.BigDecimal;
import java.math.RoundingMode;
import org.pendant.models.time.FrameTime;

/** Run frames: times of a run, which are counted in frames, as texts. */
final class RunFrames {
  private static final int MILLISECONDS = 3;

  private RunFrames() {}

  /** A number of frames in s, without zeros at its end: {@code 1.204}, {@code 0.5}, {@code 3}. */
  static String seconds(long frames) {
    return number(frames / (double) FrameTime.FRAMES_PER_SECOND, MILLISECONDS);
  }

  /** For people: {@code 1.204 s}. */
  static String text(long frames) {
    return seconds(frames) + " s";
  }

  /** A number with so many digits behind the point at most. */
  static String number(double value, int digits) {
    BigDecimal shown = BigDecimal.valueOf(value).setScale(digits, RoundingMode.HALF_UP);
    return shown.signum() == 0 ? "0" : shown.stripTrailingZeros().toPlainString();
  }
}
