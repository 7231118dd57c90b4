package org.pendant.desktop.move;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Position text: positions as URScript. */
final class PositionText {
  /** Micrometres and microradians: finer than any arm repeats. */
  private static final int DECIMALS = 6;

  private PositionText() {}

  /** Such as {@code p[0.1, 0.2, 0.3, 0, 3.141593, 0]}. */
  static String of(Pose pose) {
    return "p" + list(pose.toArray());
  }

  /** Such as {@code [0, -1.570796, 0, -1.570796, 0, 0]}. */
  static String of(Joints joints) {
    return list(joints.toArray());
  }

  private static String list(double[] numbers) {
    return Arrays.stream(numbers)
        .mapToObj(PositionText::number)
        .collect(Collectors.joining(", ", "[", "]"));
  }

  private static String number(double value) {
    BigDecimal rounded = BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }
}
