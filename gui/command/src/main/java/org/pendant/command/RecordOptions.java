package org.pendant.command;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.pendant.protocols.rtde.RtdeServer;

/**
 * Record options: what {@code pendant record} was asked for.
 *
 * @param host name or address of the controller
 * @param port of RTDE there
 * @param fields in the order of their columns
 * @param chosen whether people have named the fields
 * @param frequencyHz how often a row is written
 * @param seconds how long; empty for until Ctrl-C
 * @param out the table
 * @param separator between its cells
 */
record RecordOptions(
    String host,
    int port,
    List<String> fields,
    boolean chosen,
    double frequencyHz,
    OptionalDouble seconds,
    OutputFile out,
    char separator) {

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
          "script_control_line");

  private static final double MAX_HZ = 500;
  private static final int MAX_PORT = 65_535;

  private static final Option HOST =
      Option.text("--host", "ROBOT", "the controller, by name or address")
          .documented("192.168.0.3", "the controller, by name or address; must be given");
  private static final Option PORT =
      Option.of("--port", new OptionArgument.Whole("P", 1, MAX_PORT), "port of RTDE")
          .standing(Integer.toString(RtdeServer.STANDARD_PORT))
          .documented("30004", "its port of RTDE, default 30004");
  private static final Option FIELDS =
      Option.text("--fields", "NAME,...", "RTDE fields, default those that a comparison needs")
          .documented(
              "timestamp,actual_q",
              "which [fields](protocols/rtde-fields.md), with commas between. Without it those that"
                  + " [compare](#compare) takes, as far as the controller has them");
  private static final Option FREQUENCY =
      Option.of(
              "--frequency", new OptionArgument.Real("HZ", 1, MAX_HZ, false, "Hz"), "rows a second")
          .standing("125")
          .documented("500", "rows a second, 1 to 500, default 125; a CB3 box has 125 at most");
  private static final Option SECONDS =
      Option.of("--seconds", RunOptions.SECONDS, "how long, default until Ctrl-C")
          .documented("20", "how long; without it until Ctrl-C");
  private static final Option OUT =
      Option.output("--out", "FILE.csv", "the table to write")
          .documented("mine.csv", "the table to write; must be given");
  private static final Option SEPARATOR =
      Option.of(
              "--separator",
              new OptionArgument.Choice("space", "comma", "semicolon", "tab"),
              "between cells")
          .standing("space")
          .documented(
              "space",
              "`space` (default, as UR's `record.py` has it), `comma`, `semicolon`, `tab`");

  static final List<Option> ALL =
      List.of(HOST, PORT, FIELDS, FREQUENCY, SECONDS, OUT, OutputFile.FORCE, SEPARATOR);

  static RecordOptions of(Arguments arguments) throws UsageException {
    Optional<OutputFile> out = OutputFile.of(OUT, arguments);
    Optional<String> host = arguments.value(HOST);
    if (host.isEmpty() || host.get().isBlank()) {
      throw new UsageException("no controller named, expected " + HOST.usage());
    }
    if (out.isEmpty()) {
      throw new UsageException("no table named, expected " + OUT.usage());
    }
    if (out.get().path().toString().endsWith(".rec")) {
      throw new UsageException(
          OUT.name()
              + " "
              + out.get().path().getFileName()
              + ": a .rec has everything that is in a controller, which RTDE does not tell; name a"
              + " .csv");
    }
    Optional<String> named = arguments.value(FIELDS);
    OptionalInt port = arguments.whole(PORT);
    return new RecordOptions(
        host.get(),
        port.orElseThrow(),
        named.isPresent() ? fields(named.get()) : STANDARD_FIELDS,
        named.isPresent(),
        arguments.number(FREQUENCY).orElseThrow(),
        arguments.number(SECONDS),
        out.get(),
        separator(arguments.word(SEPARATOR).orElseThrow()));
  }

  private static List<String> fields(String text) throws UsageException {
    List<String> names = Arrays.stream(text.split(",", -1)).map(String::strip).toList();
    for (String each : names) {
      if (!each.matches("\\w+") || names.indexOf(each) != names.lastIndexOf(each)) {
        throw new UsageException(
            FIELDS.name()
                + " has '"
                + each
                + "', must be different names with commas between, such as timestamp,actual_q");
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
