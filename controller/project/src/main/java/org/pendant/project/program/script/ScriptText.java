package org.pendant.project.program.script;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Script text: values as URScript writes them. */
final class ScriptText {
  private ScriptText() {}

  /** A number that is read back as the very same one. */
  static String number(double value) {
    return Double.toString(value == 0 ? 0 : value);
  }

  static String bool(boolean value) {
    return value ? "True" : "False";
  }

  /** Such as {@code p[0.1, 0.2, 0.3, 0.0, 3.14, 0.0]}. */
  static String pose(Pose pose) {
    return "p" + list(pose.toArray());
  }

  /** Such as {@code [0.0, -1.57, 0.0, -1.57, 0.0, 0.0]}. */
  static String joints(Joints joints) {
    return list(joints.toArray());
  }

  static String list(double... values) {
    return Arrays.stream(values)
        .mapToObj(ScriptText::number)
        .collect(Collectors.joining(", ", "[", "]"));
  }

  static String list(List<Double> values) {
    return list(values.stream().mapToDouble(Double::doubleValue).toArray());
  }

  /**
   * A string. The language has no escapes: a quote becomes an apostrophe, a line end or another
   * control character a blank.
   */
  static String string(String text) {
    return '"' + oneLine(text).replace('"', '\'') + '"';
  }

  /** A condition in parentheses; one that is missing never holds. */
  static String condition(String expression) {
    String text = oneLine(expression.strip());
    return text.isEmpty() ? "(False)" : "(" + text + ")";
  }

  /** The same text on one line. */
  static String oneLine(String text) {
    return text.replace("\r\n", " ").replaceAll("\\p{Cntrl}", " ");
  }
}
