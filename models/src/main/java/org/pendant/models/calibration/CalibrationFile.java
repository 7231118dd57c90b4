package org.pendant.models.calibration;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.LinkFrames;

/**
 * Calibration file: the link frames that ROS keeps ({@code .yaml}, written by {@code
 * ur_calibration}), or the Denavit-Hartenberg deltas of a controller ({@code calibration.conf}).
 */
public final class CalibrationFile {
  /** A larger file is no calibration. */
  public static final int MAX_BYTES = 1 << 18;

  private CalibrationFile() {}

  /** True if the name is that of a file for {@link #read}. */
  public static boolean understands(String name) {
    return isYaml(name) || isConf(name);
  }

  /**
   * Reads a calibration.
   *
   * @param name of the file, by whose ending its form is known
   * @throws CalibrationTrouble if it is none
   */
  public static Calibration read(String name, byte[] bytes) throws CalibrationTrouble {
    if (bytes.length > MAX_BYTES) {
      throw new CalibrationTrouble(CalibrationTexts.text("fileTooLong", name, MAX_BYTES));
    }
    String text = new String(bytes, StandardCharsets.UTF_8);
    if (isYaml(name)) {
      return YamlCalibration.read(name, text);
    }
    if (isConf(name)) {
      return ConfCalibration.read(name, text);
    }
    throw new CalibrationTrouble(CalibrationTexts.text("wrongEnding", name));
  }

  /** The text of a file, deltas or frames; {@link #ofText} reads the same calibration from it. */
  public static String text(Calibration calibration) {
    return switch (calibration.geometry()) {
      case DhDeltas deltas ->
          ConfCalibration.text(deltas, calibration.jointChecksums(), calibration.status());
      case LinkFrames frames -> YamlCalibration.text(frames);
    };
  }

  /**
   * Reads what {@link #text} has written.
   *
   * @throws CalibrationTrouble if it is none
   */
  public static Calibration ofText(String text) throws CalibrationTrouble {
    return YamlCalibration.begins(text)
        ? YamlCalibration.read("calibration", text)
        : ConfCalibration.read("calibration", text);
  }

  private static boolean isYaml(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(".yaml") || lower.endsWith(".yml");
  }

  private static boolean isConf(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".conf");
  }
}
