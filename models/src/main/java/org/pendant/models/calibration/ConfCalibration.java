package org.pendant.models.calibration;

import static org.pendant.models.calibration.CalibrationTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.Joints;
import org.pendant.models.json.FilePosition;

/**
 * Calibration in the form of a controller's own {@code calibration.conf}: four lists of deltas, the
 * joints' checksums and a status. What else such a file has is of no use here.
 */
final class ConfCalibration {
  private static final String THETA = "delta_theta";
  private static final String A = "delta_a";
  private static final String D = "delta_d";
  private static final String ALPHA = "delta_alpha";
  private static final String CHECKSUM = "joint_checksum";
  private static final String STATUS = "calibration_status";
  private static final List<String> KEYS = List.of(THETA, A, D, ALPHA, CHECKSUM, STATUS);

  private final String file;
  private final Map<String, Setting> settings = new HashMap<>();

  /** What stands behind a key, and where. */
  private record Setting(String text, FilePosition place) {}

  private ConfCalibration(String file) {
    this.file = file;
  }

  static Calibration read(String file, String text) throws CalibrationTrouble {
    ConfCalibration conf = new ConfCalibration(file);
    conf.collect(text);
    return conf.calibration();
  }

  private void collect(String text) throws CalibrationTrouble {
    int number = 0;
    for (String line : text.split("\n", -1)) {
      number++;
      int equals = line.indexOf('=');
      String key = equals < 0 ? "" : line.substring(0, equals).strip();
      if (KEYS.contains(key)) {
        int begin = equals + 1;
        int remark = line.indexOf('#');
        String value = line.substring(begin, remark < begin ? line.length() : remark);
        int column = begin + value.length() - value.stripLeading().length() + 1;
        FilePosition place = new FilePosition(file, number, column);
        if (settings.put(key, new Setting(value.strip(), place)) != null) {
          throw CalibrationTrouble.at(place, CalibrationTexts.text("foundAgain", key));
        }
      }
    }
  }

  private Calibration calibration() throws CalibrationTrouble {
    DhDeltas deltas = new DhDeltas(lengths(THETA), lengths(A), lengths(D), lengths(ALPHA));
    Calibration made = Calibration.of(deltas);
    return new Calibration(
        deltas,
        settings.containsKey(CHECKSUM)
            ? six(CHECKSUM, CalibrationTexts.text("numberOf32Bits"), CalibrationNumbers::word)
            : made.jointChecksums(),
        settings.containsKey(STATUS) ? status() : made.status());
  }

  private Joints lengths(String key) throws CalibrationTrouble {
    List<Double> six = six(key, "a number", CalibrationNumbers::number);
    return Joints.of(six.stream().mapToDouble(Double::doubleValue).toArray());
  }

  private <T> List<T> six(String key, String kind, Function<String, Optional<T>> parse)
      throws CalibrationTrouble {
    Setting setting = settings.get(key);
    if (setting == null) {
      throw new CalibrationTrouble(CalibrationTexts.text("sixMissing", file, key, key));
    }
    String text = setting.text();
    if (!text.startsWith("[") || !text.endsWith("]")) {
      throw CalibrationTrouble.at(
          setting.place(), CalibrationTexts.text("notSix", key, shown(text)));
    }
    String[] parts = text.substring(1, text.length() - 1).split(",", -1);
    if (parts.length != Joints.COUNT) {
      throw CalibrationTrouble.at(
          setting.place(), CalibrationTexts.text("otherCount", key, parts.length));
    }
    List<T> values = new ArrayList<>();
    int column = setting.place().column() + 1;
    for (String part : parts) {
      int lead = part.length() - part.stripLeading().length();
      FilePosition place = new FilePosition(file, setting.place().line(), column + lead);
      values.add(
          parse
              .apply(part.strip())
              .orElseThrow(
                  () ->
                      CalibrationTrouble.at(
                          place,
                          CalibrationTexts.text("wrongValue", key, shown(part.strip()), kind))));
      column += part.length() + 1;
    }
    return values;
  }

  private Calibration.Status status() throws CalibrationTrouble {
    Setting setting = settings.get(STATUS);
    return switch (setting.text()) {
      case "0" -> Calibration.Status.NOT_INITIALISED;
      case "1" -> Calibration.Status.NOT_LINEARISED;
      case "2" -> Calibration.Status.LINEARISED;
      default ->
          throw CalibrationTrouble.at(
              setting.place(), CalibrationTexts.text("wrongStatus", STATUS, shown(setting.text())));
    };
  }

  private static String shown(String text) {
    if (text.isEmpty()) {
      return "nothing";
    }
    return text.length() > 40 ? text.substring(0, 40) + "..." : text;
  }

  /** The text of such a file; reading it gives the same numbers again. */
  static String text(DhDeltas deltas, List<Integer> checksums, Calibration.Status status) {
    StringBuilder text = new StringBuilder("[mounting]\n");
    line(THETA, deltas.thetaRad(), text);
    line(A, deltas.aM(), text);
    line(D, deltas.dM(), text);
    line(ALPHA, deltas.alphaRad(), text);
    List<String> words =
        checksums.stream().map(each -> String.format(Locale.ROOT, "0x%08x", each)).toList();
    text.append(CHECKSUM).append(" = [").append(String.join(", ", words)).append("]\n");
    text.append(STATUS).append(" = ").append(status.number()).append('\n');
    return text.toString();
  }

  private static void line(String key, Joints values, StringBuilder text) {
    List<String> numbers = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      numbers.add(Double.toString(values.get(i)));
    }
    text.append(key).append(" = [").append(String.join(", ", numbers)).append("]\n");
  }
}
