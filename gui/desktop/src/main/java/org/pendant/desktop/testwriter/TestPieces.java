package org.pendant.desktop.testwriter;

import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Answer;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Test pieces: parts of a test as they are written. */
final class TestPieces {
  private static final Pattern NOT_IN_STRINGS = Pattern.compile("[\"\\p{Cntrl}]+");
  private static final Pattern NOT_PLAIN = Pattern.compile("[^ !#-~]+");
  private static final Pattern NOT_IN_NAMES = Pattern.compile("[^A-Za-z0-9_]+");
  private static final int MAX_PIECE = 60;
  private static final int MAX_COMMENT = 70;
  private static final int RADIAN_DIGITS = 4;
  private static final int DEGREE_DIGITS = 4;
  private static final int VALUE_DIGITS = 6;

  private TestPieces() {}

  /** The name of a test for a word such as the name of a file. */
  static String function(String word) {
    return "test_" + NOT_IN_NAMES.matcher(word).replaceAll("_");
  }

  static String bool(boolean value) {
    return value ? "True" : "False";
  }

  /**
   * The longest piece of a text that can stand in quotes, in quotes.
   *
   * @param text bytes, one {@code char} a byte
   */
  static String piece(String text) {
    Comparator<String> byLength = Comparator.comparingInt(String::length);
    String piece =
        Stream.of(NOT_IN_STRINGS, NOT_PLAIN)
            .flatMap(
                apart ->
                    apart
                        .splitAsStream(ByteText.decoded(text))
                        .map(String::strip)
                        .filter(each -> text.contains(ByteText.asBytes(each)))
                        .max(byLength)
                        .stream())
            .max(byLength)
            .orElse("");
    return "\"" + cut(piece, MAX_PIECE) + "\"";
  }

  private static String cut(String text, int most) {
    return text.codePointCount(0, text.length()) <= most
        ? text
        : text.substring(0, text.offsetByCodePoints(0, most)).strip();
  }

  /**
   * A text in a comment.
   *
   * @param text bytes, one {@code char} a byte
   */
  static String quoted(String text) {
    String line = ByteText.decoded(text).replaceAll("[\\p{Cntrl}\\s]+", " ").strip();
    String shown = cut(line, MAX_COMMENT);
    return "\"" + shown + (shown.length() < line.length() ? "..." : "") + "\"";
  }

  /** An answer as an argument; empty where a string cannot hold it. */
  static Optional<String> of(Answer answer) {
    return switch (answer) {
      case Answer.Bool _, Answer.Whole _, Answer.Decimal _ -> Optional.of(answer.text());
      case Answer.Text(String bytes) ->
          NOT_IN_STRINGS.matcher(bytes).find()
                  || !ByteText.asBytes(ByteText.decoded(bytes)).equals(bytes)
              ? Optional.empty()
              : Optional.of("\"" + ByteText.decoded(bytes) + "\"");
    };
  }

  /** The call that sets a signal; for an output that is high already as well. */
  static String call(SignalWrite write) {
    return switch (write) {
      case SignalWrite.Digital(var signal, boolean level) ->
          "set_"
              + kind(signal.bank())
              + (signal.bank().input() ? "_in(" : "_out(")
              + signal.index()
              + ", "
              + bool(level)
              + ")";
      case SignalWrite.AnalogInput(var bank, int index, double value, var domain) ->
          "set_"
              + (bank.text().startsWith("tool") ? "tool" : "standard")
              + "_analog_in("
              + index
              + ", "
              + RunFrames.number(value, VALUE_DIGITS)
              + (domain.number() == 1 ? ")" : ", domain=0)");
      case SignalWrite.BooleanRegister(_, int address, boolean value) ->
          "write_input_boolean_register(" + address + ", " + bool(value) + ")";
      case SignalWrite.IntegerRegister(_, int address, int value) ->
          "write_input_integer_register(" + address + ", " + value + ")";
      case SignalWrite.FloatRegister(_, int address, double value) ->
          "write_input_float_register(" + address + ", " + value + ")";
      case SignalWrite.AnalogOutput _,
          SignalWrite.Domain _,
          SignalWrite.ToolVoltage _,
          SignalWrite.ToolOutputs _,
          SignalWrite.ToolPin _,
          SignalWrite.PortRegister _,
          SignalWrite.PortBit _ ->
          throw new IllegalArgumentException(write + " is nothing that a test sets");
    };
  }

  private static String kind(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN, STANDARD_OUT -> "standard_digital";
      case CONFIGURABLE_IN, CONFIGURABLE_OUT -> "configurable_digital";
      case TOOL_IN, TOOL_OUT -> "tool_digital";
      case FLAG -> throw new IllegalArgumentException("flags are no inputs or outputs");
    };
  }

  /** The condition that an output is at a level. */
  static String condition(RunStep.Output change) {
    String level = "get_" + kind(change.signal().bank()) + "_out(" + change.signal().index() + ")";
    return change.level() ? level : "not " + level;
  }

  /** A signal as assert_io_order calls it, with the name that people gave it if there is one. */
  static String named(SignalWrite write, String name) {
    String shown =
        switch (write) {
          case SignalWrite.Digital(var signal, _) -> shortName(signal.bank()) + signal.index();
          case SignalWrite.AnalogInput analog -> analog.name();
          default -> write.name().replaceAll(".*\\[", "register ").replace("]", "");
        };
    return name.isEmpty() ? shown : shown + " " + name.replaceAll("\\s+", " ");
  }

  private static String shortName(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "DI";
      case STANDARD_OUT -> "DO";
      case CONFIGURABLE_IN -> "CI";
      case CONFIGURABLE_OUT -> "CO";
      case TOOL_IN -> "TI";
      case TOOL_OUT -> "TO";
      case FLAG -> "flag ";
    };
  }

  /** Six joints in degrees, as marks have them. */
  static String degrees(Joints positionRad, int digits) {
    return list(positionRad, Math.toDegrees(1), digits);
  }

  /** Six joints in degrees, exact enough to begin a run there. */
  static String degrees(Joints positionRad) {
    return degrees(positionRad, DEGREE_DIGITS);
  }

  /** Six joints in rad, as an argument. */
  static String radians(Joints positionRad) {
    return "[" + list(positionRad, 1, RADIAN_DIGITS) + "]";
  }

  private static String list(Joints joints, double unit, int digits) {
    StringBuilder list = new StringBuilder();
    for (int i = 0; i < Joints.COUNT; i++) {
      list.append(i == 0 ? "" : ", ").append(RunFrames.number(joints.get(i) * unit, digits));
    }
    return list.toString();
  }

  /** A pose, as an argument. */
  static String pose(Pose pose) {
    StringBuilder list = new StringBuilder("p[");
    for (int i = 0; i < Pose.SIZE; i++) {
      list.append(i == 0 ? "" : ", ").append(RunFrames.number(pose.get(i), VALUE_DIGITS));
    }
    return list.append("]").toString();
  }

  /** A place in mm. */
  static String millimetres(double x, double y, double z) {
    return String.format(Locale.ROOT, "%.1f, %.1f, %.1f mm", x * 1000, y * 1000, z * 1000);
  }
}
