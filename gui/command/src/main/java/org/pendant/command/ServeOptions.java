package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import org.pendant.command.service.StateFolder;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.layout.ArmEntry;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.PendantSetup;

/**
 * Serve options: what {@code pendant serve} was asked for.
 *
 * @param controller how the controller is switched on
 * @param hosts where programs may connect to
 * @param numbers where its servers listen; Modbus and the Robot API only when that was chosen
 * @param modbusChosen whether the port of Modbus was chosen
 * @param remote who may control it at first
 * @param panel folders of programs and of log files
 * @param toolDevice the serial device at the tool connector
 * @param trace takes what goes over all connections
 * @param attachPort where editors attach to it
 */
record ServeOptions(
    ControllerOptions controller,
    AllowedHosts hosts,
    PortNumbers numbers,
    boolean modbusChosen,
    RemoteControl remote,
    PendantSetup panel,
    Optional<String> toolDevice,
    Optional<OutputFile> trace,
    OptionalInt attachPort) {

  private static final int MAX_ROBOTS = 100;

  private static final Option ROBOTS =
      Option.of("--robots", new OptionArgument.Whole("N", 1, MAX_ROBOTS))
          .standing("1")
          .documented(
              "N",
              "N robots in this process, 1 (default) to 100: the first at the address of `--host`,"
                  + " the others at those that follow it, such as 127.0.0.1 to 127.0.0.20, each"
                  + " with all its ports at their usual numbers. They share the programs folder and"
                  + " the options; each has its own state, program and folder for log files");

  private static final Option LOGS =
      Option.text("--logs", "DIR")
          .documented(
              "DIR",
              "the folder for log files and reports, default `pendant/serve/ADDRESS-OFFSET` in"
                  + " `$XDG_STATE_HOME` or `~/.local/state`");
  private static final Option READY =
      Option.flag("--ready")
          .documented(
              "begin with the arm powered, its brakes released, and in remote control. Without it"
                  + " the arm is off at first, as a real one");
  private static final Option REMOTE =
      Option.of("--remote-control", new OptionArgument.Choice("enabled", "disabled"))
          .documented(
              "enabled",
              "whether there is the feature of local and remote control: `disabled` (default) lets"
                  + " everybody control the robot, and the box says that it is not in remote"
                  + " control; `enabled` begins in local control, in which clients may only ask;"
                  + " with `--ready` it is enabled, and remote");
  private static final Option POWER_TIME =
      Option.of("--power-time", new OptionArgument.Real("S", 0, 60, false, "seconds"))
          .documented(
              "S",
              "how long it takes from an arm that is off to one that can move, 0 to 60 s, default"
                  + " 2.6; the other changes of power in proportion");

  private static final Option TRACE =
      Option.output("--trace", "FILE")
          .documented(
              "FILE",
              "write every message of every client: `FILE.pcap` for Wireshark, another name for"
                  + " [JSON lines](protocols/README.md#every-message-in-a-file)");

  /** For the usage text. */
  static final List<Option> ALL =
      Stream.concat(
              Stream.of(
                  PortOptions.HOST,
                  PortOptions.OFFSET,
                  PortOptions.MODBUS_PORT,
                  PortOptions.ROBOT_API,
                  PortOptions.PROGRAMS,
                  ROBOTS,
                  LOGS,
                  READY,
                  REMOTE,
                  POWER_TIME,
                  TRACE,
                  OutputFile.FORCE,
                  AttachPort.OPTION,
                  ToolSerialOption.OPTION),
              RunOptions.OF_CONTROLLER.stream())
          .toList();

  /** Those of each robot. */
  static List<ServeOptions> of(Arguments arguments) throws UsageException {
    PortNumbers first = PortOptions.numbers(arguments);
    int count = arguments.whole(ROBOTS).orElseThrow();
    if (count == 1) {
      return List.of(of(arguments, first, logs(arguments, first)));
    }
    requireOne(arguments, count);
    List<ServeOptions> robots = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      PortNumbers numbers = first.at(PortOptions.following(first.host(), i));
      robots.add(of(arguments, numbers, ownLogs(arguments, numbers)));
    }
    return List.copyOf(robots);
  }

  private static void requireOne(Arguments arguments, int count) throws UsageException {
    if (count == 1) {
      return;
    }
    if (ToolSerialOption.of(arguments).isPresent()) {
      throw new UsageException(text("deviceOfOneRobot", ToolSerialOption.OPTION.name(), count));
    }
    if (arguments.value(TRACE).isPresent()) {
      throw new UsageException(text("fileOfOneRobot", TRACE.name(), count));
    }
    if (arguments.has(AttachPort.OPTION)) {
      throw new UsageException(text("portOfOneRobot", AttachPort.OPTION.name(), count));
    }
  }

  private static Path ownLogs(Arguments arguments, PortNumbers numbers) throws UsageException {
    Path logs = logs(arguments, numbers);
    return arguments.value(LOGS).isPresent() ? made(logs.resolve(name(numbers))) : logs;
  }

  /**
   * Those of the arms in a cell: each at the address that the file gives it, or else at that of
   * {@code --host} and those that follow it.
   *
   * @param members of the cell, in their order
   */
  static List<ServeOptions> of(Arguments arguments, CellFile file, List<CellFile.Member> members)
      throws UsageException {
    PortNumbers first = PortOptions.numbers(arguments);
    List<ArmEntry> arms = file.plan().arms();
    if (arguments.has(ROBOTS)) {
      throw new UsageException(text("noCellOfItsOwn", ROBOTS.name(), file.name()));
    }
    requireOne(arguments, arms.size());
    List<ServeOptions> robots = new ArrayList<>();
    Set<InetAddress> taken = new HashSet<>();
    for (int i = 0; i < arms.size(); i++) {
      Optional<String> address =
          arguments.has(PortOptions.HOST) ? Optional.empty() : arms.get(i).address();
      InetAddress host =
          address.isPresent()
              ? InetAddress.ofLiteral(address.get())
              : PortOptions.following(first.host(), i);
      if (!taken.add(host)) {
        throw new UsageException(
            arms.get(i)
                .place()
                .refusal(text("sameAddress", arms.get(i).name(), host.getHostAddress()))
                .getMessage());
      }
      PortNumbers numbers = first.at(host);
      Path logs = arms.size() > 1 ? ownLogs(arguments, numbers) : logs(arguments, numbers);
      robots.add(of(members.get(i).options(), arguments, numbers, logs));
    }
    return List.copyOf(robots);
  }

  private static ServeOptions of(Arguments arguments, PortNumbers numbers, Path logs)
      throws UsageException {
    return of(RunOptions.controller(arguments), arguments, numbers, logs);
  }

  private static ServeOptions of(
      ControllerOptions options, Arguments arguments, PortNumbers numbers, Path logs)
      throws UsageException {
    boolean ready = arguments.has(READY);
    Path programs = PortOptions.programs(arguments);
    ControllerOptions controller =
        options
            .withMeasuredNoise(SimulationOptions.measuredNoise(arguments, true))
            .withOperator(Operator.present())
            .withPower(ready)
            .withPowerTimes(powerTimes(arguments))
            .withSystemTime(InstantSource.system())
            .withProgramsFolder(ProgramsFolder.at(programs));
    return new ServeOptions(
        controller,
        HostsOption.of(arguments),
        numbers,
        arguments.has(PortOptions.MODBUS_PORT),
        new RemoteControl(remoteEnabled(arguments, ready), ready),
        new PendantSetup(
            controller.robotId(), ProgramsFolder.at(programs), logs, ControlOption.of(arguments)),
        ToolSerialOption.of(arguments),
        trace(arguments),
        arguments.whole(AttachPort.OPTION));
  }

  private static Optional<OutputFile> trace(Arguments arguments) throws UsageException {
    if (arguments.has(OutputFile.FORCE) && arguments.value(TRACE).isEmpty()) {
      throw new UsageException(text("forceGoesWithTrace"));
    }
    return OutputFile.of(TRACE, arguments);
  }

  private static Path logs(Arguments arguments, PortNumbers numbers) throws UsageException {
    Optional<String> chosen = arguments.value(LOGS);
    if (chosen.isPresent()) {
      return made(PortOptions.path(LOGS, chosen.get()));
    }
    return StateFolder.of(System.getenv()).resolve("serve").resolve(name(numbers));
  }

  private static String name(PortNumbers numbers) {
    return numbers.host().getHostAddress().replace(':', '_') + "-" + numbers.offset();
  }

  /**
   * The folder, which the user has chosen: that it cannot be is said now, not when it is needed.
   */
  private static Path made(Path folder) throws UsageException {
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new UsageException(text("cannotBeMadeFolder", LOGS.name(), folder));
    }
    if (!Files.isWritable(folder)) {
      throw new UsageException(text("folderCannotBeWritten", LOGS.name(), folder));
    }
    return folder;
  }

  private static PowerTimes powerTimes(Arguments arguments) throws UsageException {
    OptionalDouble totalS = arguments.number(POWER_TIME);
    return totalS.isPresent() ? PowerTimes.ofTotal(totalS.getAsDouble()) : PowerTimes.REAL;
  }

  private static boolean remoteEnabled(Arguments arguments, boolean ready) throws UsageException {
    return arguments.word(REMOTE).map(word -> word.equals("enabled")).orElse(ready);
  }
}
