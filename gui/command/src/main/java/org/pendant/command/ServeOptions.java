package org.pendant.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.command.service.StateFolder;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.PendantSetup;

/**
 * What {@code pendant serve} was asked for.
 *
 * @param controller how the controller is switched on
 * @param hosts where programs may connect to
 * @param numbers where its servers listen; Modbus and the Robot API only when that was chosen
 * @param modbusChosen whether the port of Modbus was chosen
 * @param remote who may control it at first
 * @param panel folders of programs and of log files
 * @param toolDevice the serial device at the tool connector
 */
record ServeOptions(
    ControllerOptions controller,
    AllowedHosts hosts,
    PortNumbers numbers,
    boolean modbusChosen,
    RemoteControl remote,
    PendantSetup panel,
    Optional<String> toolDevice) {

  private static final int MAX_ROBOTS = 100;

  private static final Option ROBOTS =
      new Option(
          "--robots", "N", "serve N robots, at the address of --host and those that follow it");

  private static final Option LOGS =
      new Option("--logs", "DIR", "folder for log files and reports");
  private static final Option READY =
      new Option("--ready", "", "begin with the arm running and in remote control");
  private static final Option REMOTE =
      new Option(
          "--remote-control",
          "enabled|disabled",
          "whether there is local and remote control, default disabled, with --ready enabled");
  private static final Option POWER_TIME =
      new Option(
          "--power-time", "S", "seconds from switching on until the arm can move, default 2.6");

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
                  ToolSerialOption.OPTION),
              RunOptions.OF_CONTROLLER.stream())
          .toList();

  /** Those of each robot. */
  static List<ServeOptions> of(Arguments arguments) throws UsageException {
    PortNumbers first = PortOptions.numbers(arguments);
    int count = PortOptions.number(arguments, ROBOTS, 1, MAX_ROBOTS).orElse(1);
    if (count == 1) {
      return List.of(of(arguments, first, logs(arguments, first)));
    }
    if (ToolSerialOption.of(arguments).isPresent()) {
      throw new UsageException(
          ToolSerialOption.OPTION.name() + " is the device of one robot, there are " + count);
    }
    List<ServeOptions> robots = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      PortNumbers numbers = first.at(PortOptions.following(first.host(), i));
      Path logs = logs(arguments, numbers);
      robots.add(
          of(
              arguments,
              numbers,
              arguments.value(LOGS).isPresent() ? made(logs.resolve(name(numbers))) : logs));
    }
    return List.copyOf(robots);
  }

  private static ServeOptions of(Arguments arguments, PortNumbers numbers, Path logs)
      throws UsageException {
    boolean ready = arguments.has(READY);
    Path programs = PortOptions.programs(arguments);
    ControllerOptions controller =
        RunOptions.controller(arguments)
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
        ToolSerialOption.of(arguments));
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
   * The folder, which somebody has chosen: that it cannot be is said now, not when it is needed.
   */
  private static Path made(Path folder) throws UsageException {
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new UsageException(LOGS.name() + " is " + folder + ", which cannot be made a folder");
    }
    if (!Files.isWritable(folder)) {
      throw new UsageException(LOGS.name() + " is " + folder + ", which cannot be written");
    }
    return folder;
  }

  private static PowerTimes powerTimes(Arguments arguments) throws UsageException {
    Optional<String> text = arguments.value(POWER_TIME);
    if (text.isEmpty()) {
      return PowerTimes.REAL;
    }
    double totalS = RunOptions.number(text.get(), POWER_TIME.name(), "0 to 60 seconds");
    if (!(totalS >= 0 && totalS <= 60)) {
      throw new UsageException("--power-time is " + text.get() + ", must be 0 to 60 seconds");
    }
    return PowerTimes.ofTotal(totalS);
  }

  private static boolean remoteEnabled(Arguments arguments, boolean ready) throws UsageException {
    Optional<String> word = arguments.value(REMOTE);
    if (word.isEmpty()) {
      return ready;
    }
    return switch (word.get()) {
      case "enabled" -> true;
      case "disabled" -> false;
      default ->
          throw new UsageException(
              "--remote-control is " + word.get() + ", must be enabled or disabled");
    };
  }
}
