package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.pendant.models.arm.ArmDescription;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.recording.ReceivedRecording;

/**
 * Record options: what {@code pendant record} was asked for.
 *
 * @param host name or address of the controller
 * @param port of RTDE there
 * @param fields in the order of their columns
 * @param chosen whether people have named the fields
 * @param frequencyHz how often a row is written
 * @param seconds how long; empty for until Ctrl-C
 * @param out tables and recordings
 * @param separator between the cells of tables
 * @param arm that the controller has; empty where that does not matter
 */
record RecordOptions(
    String host,
    int port,
    List<String> fields,
    boolean chosen,
    double frequencyHz,
    OptionalDouble seconds,
    List<OutputFile> out,
    char separator,
    Optional<ArmDescription> arm) {

  /** What tells how an arm moves, and what a comparison needs. */
  static final List<String> STANDARD_FIELDS =
      List.of(
          "timestamp",
          "target_q",
          "target_qd",
          "target_qdd",
          "target_current",
          "target_moment",
          "actual_q",
          "actual_qd",
          "actual_current",
          "target_TCP_pose",
          "actual_TCP_pose",
          "target_TCP_speed",
          "actual_TCP_speed",
          "actual_TCP_force",
          "tcp_offset",
          "payload",
          "payload_cog",
          "actual_tool_accelerometer",
          "joint_temperatures",
          "actual_joint_voltage",
          "actual_main_voltage",
          "actual_robot_voltage",
          "actual_robot_current",
          "actual_momentum",
          "speed_scaling",
          "target_speed_fraction",
          "robot_mode",
          "safety_mode",
          "runtime_state",
          "script_control_line",
          "actual_digital_input_bits",
          "actual_digital_output_bits");

  /** What a recording cannot do without. */
  private static final List<String> NEEDED = List.of(ReceivedRecording.TIME, "actual_q");

  private static final String RECORDING = ".rec";

  private static final double MAX_HZ = 500;
  private static final int MAX_PORT = 65_535;

  private static final Option HOST =
      Option.text("--host", "ROBOT")
          .explained("--host.record")
          .documented("192.168.0.3", "the controller, by name or address; must be given");
  private static final Option PORT =
      Option.of("--port", new OptionArgument.Whole("P", 1, MAX_PORT))
          .explained("--port.record")
          .standing(Integer.toString(RtdeServer.STANDARD_PORT))
          .documented("30004", "its port of RTDE, default 30004");
  private static final Option FIELDS =
      Option.text("--fields", "NAME,...")
          .documented(
              "timestamp,actual_q",
              "which [fields](protocols/rtde-fields.md), with commas between. Without it those that"
                  + " [compare](#compare) takes, as far as the controller has them");
  private static final Option FREQUENCY =
      Option.of("--frequency", new OptionArgument.Real("HZ", 1, MAX_HZ, false, "Hz"))
          .explained("--frequency.record")
          .standing("125")
          .documented("500", "rows a second, 1 to 500, default 125; a CB3 box has 125 at most");
  private static final Option SECONDS =
      Option.of("--seconds", RunOptions.SECONDS)
          .documented("20", "how long; without it until Ctrl-C");
  private static final Option OUT =
      Option.output("--out", "FILE")
          .explained("--out.record")
          .repeated()
          .documented(
              "mine.csv",
              "what to write: a table, or a [recording](recording.md) where the name ends in"
                  + " `.rec`; must be given, and may be repeated to have both");
  private static final Option SEPARATOR =
      Option.of("--separator", new OptionArgument.Choice("space", "comma", "semicolon", "tab"))
          .standing("space")
          .documented(
              "space",
              "`space` (default, as UR's `record.py` has it), `comma`, `semicolon`, `tab`");

  static final List<Option> ALL =
      List.of(
          HOST,
          PORT,
          FIELDS,
          FREQUENCY,
          SECONDS,
          OUT,
          OutputFile.FORCE,
          SEPARATOR,
          RunOptions.ROBOT,
          CalibrationOption.OPTION);

  RecordOptions {
    out = List.copyOf(out);
  }

  /** Whether a file is a {@code .rec}, by its name. */
  static boolean isRecording(OutputFile file) {
    return file.path().toString().toLowerCase(Locale.ROOT).endsWith(RECORDING);
  }

  static RecordOptions of(Arguments arguments) throws UsageException {
    List<String> names = arguments.values(OUT);
    Optional<ArmDescription> arm = arm(arguments);
    List<OutputFile> out = new ArrayList<>();
    for (String each : names) {
      out.add(OutputFile.of(OUT, each, arguments));
    }
    Optional<String> host = arguments.value(HOST);
    if (host.isEmpty() || host.get().isBlank()) {
      throw new UsageException(text("noControllerNamed", HOST.usage()));
    }
    if (out.isEmpty()) {
      throw new UsageException(text("noFileNamed", OUT.usage()));
    }
    if (new HashSet<>(names).size() < names.size()) {
      throw new UsageException(text("sameFileTwice", OUT.name()));
    }
    Optional<String> named = arguments.value(FIELDS);
    List<String> fields = named.isPresent() ? fields(named.get()) : STANDARD_FIELDS;
    if (out.stream().anyMatch(RecordOptions::isRecording)) {
      if (arm.isEmpty()) {
        throw new UsageException(text("armMissing", RunOptions.ROBOT.usage()));
      }
      if (!fields.containsAll(NEEDED)) {
        throw new UsageException(
            text("fieldsMissing", FIELDS.name(), String.join(" and ", NEEDED)));
      }
    }
    OptionalInt port = arguments.whole(PORT);
    return new RecordOptions(
        host.get(),
        port.orElseThrow(),
        fields,
        named.isPresent(),
        arguments.number(FREQUENCY).orElseThrow(),
        arguments.number(SECONDS),
        out,
        separator(arguments.word(SEPARATOR).orElseThrow()),
        arm);
  }

  private static Optional<ArmDescription> arm(Arguments arguments) throws UsageException {
    ArmDescription model = RobotName.model(arguments);
    ArmDescription arm =
        model.withCalibration(CalibrationOption.of(arguments, Optional.empty(), model));
    return arguments.has(RunOptions.ROBOT) ? Optional.of(arm) : Optional.empty();
  }

  private static List<String> fields(String text) throws UsageException {
    List<String> names = Arrays.stream(text.split(",", -1)).map(String::strip).toList();
    for (String each : names) {
      if (!each.matches("\\w+") || names.indexOf(each) != names.lastIndexOf(each)) {
        throw new UsageException(text("fieldsMustBe", FIELDS.name(), each));
      }
    }
    return names;
  }

  private static char separator(String word) {
    return switch (word) {
      case "comma" -> ',';
      case "semicolon" -> ';';
      case "tab" -> '\t';
      default -> ' ';
    };
  }
}
