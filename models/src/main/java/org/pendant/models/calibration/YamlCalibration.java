package org.pendant.models.calibration;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.LinkFrame;
import org.pendant.models.arm.LinkFrames;

/** Calibration in YAML as {@code ur_calibration} of ROS writes it: six frames and a hash. */
final class YamlCalibration {
  private static final String KINEMATICS = "kinematics";

  /** By which ROS tells calibrations apart; nothing can be made from it. */
  private static final String HASH = "hash";

  private static final List<String> NUMBERS = List.of("x", "y", "z", "roll", "pitch", "yaw");

  private YamlCalibration() {}

  static Calibration read(String file, String text) throws CalibrationTrouble {
    Yaml.Mapping root = YamlReader.read(file, text);
    requireKnown(root, List.of(KINEMATICS));
    Yaml.Mapping kinematics = mapping(root, KINEMATICS);
    List<String> known = new ArrayList<>(LinkFrames.NAMES);
    known.add(HASH);
    requireKnown(kinematics, known);
    List<LinkFrame> frames = new ArrayList<>();
    for (String name : LinkFrames.NAMES) {
      frames.add(frame(mapping(kinematics, name)));
    }
    try {
      return Calibration.of(new LinkFrames(frames));
    } catch (IllegalArgumentException e) {
      // only what the shoulder must be is left to be wrong
      throw CalibrationTrouble.at(
          mapping(kinematics, LinkFrames.NAMES.getFirst()).place(), e.getMessage());
    }
  }

  /** Whether a text is in this form, if it is a calibration at all. */
  static boolean begins(String text) {
    return text.startsWith(KINEMATICS);
  }

  /** The text of such a file, without a hash. */
  static String text(LinkFrames geometry) {
    StringBuilder text = new StringBuilder(KINEMATICS + ":\n");
    for (int i = 0; i < LinkFrames.NAMES.size(); i++) {
      LinkFrame frame = geometry.frames().get(i);
      text.append("  ").append(LinkFrames.NAMES.get(i)).append(":\n");
      double[] values = {
        frame.xM(), frame.yM(), frame.zM(), frame.rollRad(), frame.pitchRad(), frame.yawRad()
      };
      for (int k = 0; k < values.length; k++) {
        text.append("    ").append(NUMBERS.get(k)).append(": ").append(values[k]).append('\n');
      }
    }
    return text.toString();
  }

  private static LinkFrame frame(Yaml.Mapping frame) throws CalibrationTrouble {
    requireKnown(frame, NUMBERS);
    return new LinkFrame(
        number(frame, "x"),
        number(frame, "y"),
        number(frame, "z"),
        number(frame, "roll"),
        number(frame, "pitch"),
        number(frame, "yaw"));
  }

  private static void requireKnown(Yaml.Mapping mapping, List<String> known)
      throws CalibrationTrouble {
    for (var each : mapping.entries().entrySet()) {
      if (!known.contains(each.getKey())) {
        throw CalibrationTrouble.at(
            each.getValue().place(),
            CalibrationTexts.text("unknownKey", each.getKey(), String.join(", ", known)));
      }
    }
  }

  private static Yaml value(Yaml.Mapping mapping, String key) throws CalibrationTrouble {
    Yaml.Entry entry = mapping.entries().get(key);
    if (entry == null) {
      throw CalibrationTrouble.at(mapping.place(), CalibrationTexts.text("missing", key));
    }
    return entry.value();
  }

  private static Yaml.Mapping mapping(Yaml.Mapping in, String key) throws CalibrationTrouble {
    return switch (value(in, key)) {
      case Yaml.Mapping mapping -> mapping;
      case Yaml.Scalar scalar ->
          throw CalibrationTrouble.at(
              scalar.place(), CalibrationTexts.text("noNumbers", shown(scalar), key));
    };
  }

  private static double number(Yaml.Mapping in, String key) throws CalibrationTrouble {
    return switch (value(in, key)) {
      case Yaml.Scalar scalar ->
          CalibrationNumbers.number(scalar.text())
              .orElseThrow(
                  () ->
                      CalibrationTrouble.at(
                          scalar.place(), CalibrationTexts.text("noNumber", key, shown(scalar))));
      case Yaml.Mapping mapping ->
          throw CalibrationTrouble.at(
              mapping.place(), CalibrationTexts.text("mappingForNumber", key));
    };
  }

  private static String shown(Yaml.Scalar scalar) {
    return scalar.text().isEmpty() ? "nothing" : scalar.text();
  }
}
