package org.pendant.gui.command;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.protocols.panel.PanelSetup;
import org.pendant.protocols.reach.AllowedHosts;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.RemoteControl;
import org.pendant.protocols.toolserial.ToolSerialServer;

/**
 * What {@code pendant serve} was asked for.
 *
 * @param controller how the controller is switched on
 * @param hosts where programs may connect to
 * @param numbers where its servers listen; Modbus only when that was chosen
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
    PanelSetup panel,
    Optional<String> toolDevice) {

  /** Where Modbus servers listen everywhere. */
  static final int MODBUS = 502;

  /** The largest port, that of the tool's serial line, must still be one. */
  private static final int LARGEST_OFFSET = 65_535 - ToolSerialServer.STANDARD_PORT;

  private static final Option HOST =
      new Option("--host", "ADDRESS", "where to listen, default 127.0.0.1");
  private static final Option OFFSET =
      new Option("--port-offset", "N", "add N to every port, default 0");
  private static final Option MODBUS_PORT =
      new Option("--modbus-port", "P", "port of Modbus, default 502, or 1502 without the right");
  private static final Option PROGRAMS =
      new Option("--programs", "DIR", "folder of the programs, default the present one");
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
                  HOST,
                  OFFSET,
                  MODBUS_PORT,
                  PROGRAMS,
                  LOGS,
                  READY,
                  REMOTE,
                  POWER_TIME,
                  ToolSerialOption.OPTION),
              RunOptions.OF_CONTROLLER.stream())
          .toList();

  static ServeOptions of(Arguments arguments) throws UsageException {
    boolean ready = arguments.has(READY);
    Path programs = programs(arguments);
    ControllerOptions controller =
        RunOptions.controller(arguments)
            .withOperator(Operator.present())
            .withPower(ready)
            .withPowerTimes(powerTimes(arguments))
            .withSystemTime(InstantSource.system())
            .withProgramsFolder(ProgramsFolder.at(programs));
    PortNumbers numbers = numbers(arguments);
    return new ServeOptions(
        controller,
        HostsOption.of(arguments),
        numbers,
        arguments.has(MODBUS_PORT),
        new RemoteControl(remoteEnabled(arguments, ready), ready),
        new PanelSetup(controller.robotId(), ProgramsFolder.at(programs), logs(arguments, numbers)),
        ToolSerialOption.of(arguments));
  }

  private static PortNumbers numbers(Arguments arguments) throws UsageException {
    int offset = number(arguments, OFFSET, 0, LARGEST_OFFSET).orElse(0);
    PortNumbers numbers = new PortNumbers(host(arguments), offset, false);
    Optional<Integer> modbus = number(arguments, MODBUS_PORT, 1, 65_535);
    return modbus.isPresent() ? numbers.with(MODBUS, modbus.get()) : numbers;
  }

  private static InetAddress host(Arguments arguments) throws UsageException {
    String name = arguments.value(HOST).orElse("127.0.0.1");
    try {
      return InetAddress.getByName(name);
    } catch (UnknownHostException e) {
      throw new UsageException("--host is " + name + ", must be an address of this machine");
    }
  }

  private static Optional<Integer> number(Arguments arguments, Option option, int least, int most)
      throws UsageException {
    Optional<String> text = arguments.value(option);
    if (text.isEmpty()) {
      return Optional.empty();
    }
    try {
      int number = Integer.parseInt(text.get());
      if (number >= least && number <= most) {
        return Optional.of(number);
      }
    } catch (NumberFormatException e) {
      // said below, as for a number out of range
    }
    throw new UsageException(
        option.name() + " is " + text.get() + ", must be a number from " + least + " to " + most);
  }

  private static Path programs(Arguments arguments) throws UsageException {
    Path folder = path(PROGRAMS, arguments.value(PROGRAMS).orElse("."));
    if (!Files.isDirectory(folder)) {
      throw new UsageException("--programs is " + folder + ", must be a folder");
    }
    return folder;
  }

  private static Path logs(Arguments arguments, PortNumbers numbers) throws UsageException {
    Optional<String> chosen = arguments.value(LOGS);
    if (chosen.isPresent()) {
      return path(LOGS, chosen.get());
    }
    String states = System.getenv().getOrDefault("XDG_STATE_HOME", "");
    Path folder =
        states.isEmpty()
            ? Path.of(System.getProperty("user.home"), ".local", "state")
            : Path.of(states);
    String box = numbers.host().getHostAddress().replace(':', '_') + "-" + numbers.offset();
    return folder.resolve("pendant").resolve("serve").resolve(box);
  }

  private static Path path(Option option, String name) throws UsageException {
    try {
      return Path.of(name).toAbsolutePath().normalize();
    } catch (InvalidPathException e) {
      throw new UsageException(option.name() + " is " + name + ", which is no name of a folder");
    }
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
