package org.pendant.editors.lsp.provider;

import static org.pendant.editors.lsp.provider.AnswerTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Rotations;

/** Human units: lengths in mm and angles in degrees, as people at a robot speak of them. */
final class HumanUnits {
  private static final double MM_PER_M = 1000;

  private HumanUnits() {}

  /** A number with at most six decimals, and none that are zero. */
  static String number(double value) {
    return rounded(value, 6);
  }

  /** The same amount in the other unit; empty for those that people use as they are. */
  static Optional<String> converted(double value, Unit unit) {
    return switch (unit) {
      case METRE -> Optional.of(rounded(value * MM_PER_M, 3) + " mm");
      case METRE_PER_SECOND -> Optional.of(rounded(value * MM_PER_M, 3) + " mm/s");
      case METRE_PER_SECOND_SQUARED -> Optional.of(rounded(value * MM_PER_M, 3) + " mm/s²");
      case RADIAN -> Optional.of(rounded(Math.toDegrees(value), 3) + "°");
      case RADIAN_PER_SECOND -> Optional.of(rounded(Math.toDegrees(value), 3) + "°/s");
      case RADIAN_PER_SECOND_SQUARED -> Optional.of(rounded(Math.toDegrees(value), 3) + "°/s²");
      case DEGREE -> Optional.of(rounded(Math.toRadians(value), 5) + " rad");
      case NONE, SECOND, KILOGRAM, NEWTON, NEWTON_METRE, VOLT, AMPERE, HERTZ, CELSIUS ->
          Optional.empty();
    };
  }

  /**
   * A pose in one line.
   *
   * @param pose x, y, z in m, then the rotation vector in rad
   */
  static String shortPose(List<Double> pose) {
    double[] rpy = rpy(pose);
    return String.format(
        "%s, %s, %s mm · RPY %s°, %s°, %s°",
        rounded(pose.get(0) * MM_PER_M, 1),
        rounded(pose.get(1) * MM_PER_M, 1),
        rounded(pose.get(2) * MM_PER_M, 1),
        rounded(Math.toDegrees(rpy[0]), 1),
        rounded(Math.toDegrees(rpy[1]), 1),
        rounded(Math.toDegrees(rpy[2]), 1));
  }

  /** A pose in lines: position, rotation vector, and roll, pitch and yaw. */
  static List<String> lines(List<Double> pose, ClientFeatures client) {
    double[] rpy = rpy(pose);
    return List.of(
        String.format(
            "x %s mm, y %s mm, z %s mm",
            rounded(pose.get(0) * MM_PER_M, 3),
            rounded(pose.get(1) * MM_PER_M, 3),
            rounded(pose.get(2) * MM_PER_M, 3)),
        client.shown(
            text(
                "rotationVector",
                rounded(Math.toDegrees(pose.get(3)), 3),
                rounded(Math.toDegrees(pose.get(4)), 3),
                rounded(Math.toDegrees(pose.get(5)), 3))),
        client.shown(
            text(
                "rollPitchYaw",
                rounded(Math.toDegrees(rpy[0]), 3),
                rounded(Math.toDegrees(rpy[1]), 3),
                rounded(Math.toDegrees(rpy[2]), 3))));
  }

  private static double[] rpy(List<Double> pose) {
    double[] rpy = new double[3];
    Rotations.vectorToRpy(pose.get(3), pose.get(4), pose.get(5), rpy);
    return rpy;
  }

  private static String rounded(double value, int decimals) {
    String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
    if (text.indexOf('.') >= 0) {
      text = text.replaceFirst("0+$", "").replaceFirst("\\.$", "");
    }
    return text.equals("-0") ? "0" : text;
  }
}
