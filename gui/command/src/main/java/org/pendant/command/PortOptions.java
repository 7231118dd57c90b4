package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.command.service.PortWishes;
import org.pendant.protocols.modbus.ModbusServer;
import org.pendant.protocols.robotapi.RobotApiServer;
import org.pendant.protocols.server.AddressRow;
import org.pendant.protocols.server.PortNumbers;

/** Port options: say where servers listen. */
final class PortOptions {
  /** Where Modbus servers listen everywhere. */
  static final int MODBUS = ModbusServer.STANDARD_PORT;

  private static final OptionArgument PORT = new OptionArgument.Whole("P", 1, PortWishes.MAX_PORT);

  static final Option HOST =
      Option.text("--host", "ADDRESS")
          .standing(PortWishes.STANDARD_HOST)
          .documented(
              "127.0.0.1",
              "where to listen. Any computer that reaches another address than a loopback one can"
                  + " move the robot, as there are no passwords; a warning says so");
  static final Option OFFSET =
      Option.of("--port-offset", new OptionArgument.Whole("N", 0, PortWishes.MAX_OFFSET))
          .standing("0")
          .documented("N", "is added to every port, 0 (default) to 11214");
  static final Option MODBUS_PORT =
      Option.of("--modbus-port", PORT)
          .documented(
              "P",
              "port of Modbus. Default 502 and the offset; where the system does not allow that,"
                  + " 1000 more, which is said");
  static final Option ROBOT_API =
      Option.of("--robot-api", PORT)
          .documented(
              "P",
              "open the [Robot API](protocols/robot-api.md) of PolyScope X at this port; the offset"
                  + " does not count. Without it there is none");
  static final Option PROGRAMS =
      Option.text("--programs", "DIR")
          .documented(
              "DIR",
              "the folder of the programs, default the present one: what `load` loads, and what"
                  + " programs may read");

  /** All of them, for the usage text. */
  static final List<Option> ALL = List.of(HOST, OFFSET, MODBUS_PORT, PROGRAMS);

  private PortOptions() {}

  /** Where the servers listen; Modbus and the Robot API apart only when that was chosen. */
  static PortNumbers numbers(Arguments arguments) throws UsageException {
    PortNumbers numbers = new PortNumbers(host(arguments), offset(arguments), false);
    OptionalInt modbus = arguments.whole(MODBUS_PORT);
    PortNumbers known = modbus.isPresent() ? numbers.with(MODBUS, modbus.getAsInt()) : numbers;
    OptionalInt api = arguments.whole(ROBOT_API);
    return api.isPresent() ? known.with(RobotApiServer.STANDARD_PORT, api.getAsInt()) : known;
  }

  /** The same for the desktop, where people may change it. */
  static PortWishes wishes(Arguments arguments) throws UsageException {
    return new PortWishes(
        host(arguments).getHostAddress(),
        offset(arguments),
        arguments.whole(MODBUS_PORT),
        programs(arguments),
        true);
  }

  /** The folder of the programs. */
  static Path programs(Arguments arguments) throws UsageException {
    Path folder = path(PROGRAMS, arguments.value(PROGRAMS).orElse("."));
    if (!Files.isDirectory(folder)) {
      throw new UsageException(text("programsMustBe", folder));
    }
    return folder;
  }

  /** The folder that is called {@code name}. */
  static Path path(Option option, String name) throws UsageException {
    try {
      return Path.of(name).toAbsolutePath().normalize();
    } catch (InvalidPathException e) {
      throw new UsageException(text("noNameOfFolder", option.name(), name));
    }
  }

  private static InetAddress host(Arguments arguments) throws UsageException {
    String name = arguments.text(HOST);
    if (name.isBlank()) {
      // for Java that would be the loopback address
      throw new UsageException(text("hostEmpty"));
    }
    try {
      return InetAddress.getByName(name);
    } catch (UnknownHostException e) {
      throw new UsageException(text("hostMustBe", name));
    }
  }

  /** The address that follows {@code first} after {@code steps}. */
  static InetAddress following(InetAddress first, int steps) throws UsageException {
    Optional<InetAddress> following = AddressRow.after(first, steps);
    if (following.isEmpty()) {
      throw new UsageException(text("hostMustBeFirst", first.getHostAddress()));
    }
    return following.get();
  }

  private static int offset(Arguments arguments) throws UsageException {
    return arguments.whole(OFFSET).orElseThrow();
  }
}
