package org.pendant.recording.explain;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Move call: what a line of a program asks of a move, as far as it says it in numbers.
 *
 * @param name of the function, such as {@code movel}
 * @param acceleration rad/s² or m/s²; empty where it is not known
 * @param speed rad/s or m/s; empty where it is not known, or a time is asked for
 * @param timed whether a time is asked for
 */
record MoveCall(String name, OptionalDouble acceleration, OptionalDouble speed, boolean timed) {
  private static final Pattern CALL = Pattern.compile("\\b(movej|movel|movep)\\s*\\(");
  private static final Pattern STREAM =
      Pattern.compile("\\b(servoj|servol|speedj|speedl|stopj|stopl)\\s*\\(");
  private static final Pattern NAMED = Pattern.compile("\\s*([avtr])\\s*=(?!=)\\s*(.*)");
  private static final double JOINT_ACCELERATION = 1.4;
  private static final double JOINT_SPEED = 1.05;
  private static final double TOOL_ACCELERATION = 1.2;
  private static final double TOOL_SPEED = 0.25;

  /** Whether speeds are those of joints. */
  boolean ofJoints() {
    return name.equals("movej");
  }

  /**
   * Reads a line.
   *
   * @param variables answers the value of a variable, if it is known
   */
  static Optional<MoveCall> of(String line, Function<String, OptionalDouble> variables) {
    Matcher call = CALL.matcher(line);
    if (!call.find()) {
      return Optional.empty();
    }
    boolean joints = call.group(1).equals("movej");
    OptionalDouble acceleration =
        OptionalDouble.of(joints ? JOINT_ACCELERATION : TOOL_ACCELERATION);
    OptionalDouble speed = OptionalDouble.of(joints ? JOINT_SPEED : TOOL_SPEED);
    boolean timed = false;
    List<String> arguments = arguments(line.substring(call.end()));
    for (int i = 1; i < arguments.size(); i++) {
      Matcher named = NAMED.matcher(arguments.get(i));
      boolean isNamed = named.matches();
      char name = isNamed ? named.group(1).charAt(0) : i <= 3 ? "avt".charAt(i - 1) : 'r';
      OptionalDouble value = value(isNamed ? named.group(2) : arguments.get(i), variables);
      switch (name) {
        case 'a' -> acceleration = value;
        case 'v' -> speed = value;
        case 't' -> timed = value.orElse(1) > 0;
        default -> {}
      }
    }
    return Optional.of(
        new MoveCall(
            call.group(1),
            timed ? OptionalDouble.empty() : acceleration,
            timed ? OptionalDouble.empty() : speed,
            timed));
  }

  /** Whether a line is of those by which a program sets speeds or targets itself. */
  static boolean streams(String line) {
    return STREAM.matcher(line).find();
  }

  private static OptionalDouble value(String text, Function<String, OptionalDouble> variables) {
    String plain = text.strip();
    try {
      return OptionalDouble.of(Double.parseDouble(plain));
    } catch (NumberFormatException e) {
      return plain.matches("[A-Za-z_]\\w*") ? variables.apply(plain) : OptionalDouble.empty();
    }
  }

  /** What stands between the commas of a call, up to its end. */
  private static List<String> arguments(String text) {
    List<String> arguments = new ArrayList<>();
    int depth = 0;
    int start = 0;
    boolean quoted = false;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      quoted ^= c == '"';
      if (quoted) {
        continue;
      }
      if ((c == ',' && depth == 0) || (c == ')' && depth == 0)) {
        arguments.add(text.substring(start, i));
        start = i + 1;
        if (c == ')') {
          return arguments;
        }
      } else if (c == '(' || c == '[') {
        depth++;
      } else if (c == ')' || c == ']') {
        depth--;
      }
    }
    return arguments;
  }
}
