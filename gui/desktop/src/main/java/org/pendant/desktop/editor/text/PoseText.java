package org.pendant.desktop.editor.text;

import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;
import org.pendant.models.pose.Pose;

/** Pose text: a pose as scripts print it. */
final class PoseText {
  private static final String NUMBER = "[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d{1,3})?";
  private static final Pattern POSE =
      Pattern.compile("p\\[\\s*" + NUMBER + "(?:\\s*,\\s*" + NUMBER + "){5}\\s*]");

  private PoseText() {}

  /** Such as that of {@code p[0.4, -0.3, 0.2, 0, 3.1416, 0]}; empty for other values. */
  static Optional<Pose> read(String text) {
    String value = text.strip();
    if (!POSE.matcher(value).matches()) {
      return Optional.empty();
    }
    String[] parts = value.substring(2, value.length() - 1).split(",", -1);
    return Optional.of(Pose.of(Arrays.stream(parts).mapToDouble(Double::parseDouble).toArray()));
  }
}
