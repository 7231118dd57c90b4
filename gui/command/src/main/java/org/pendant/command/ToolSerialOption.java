package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.Optional;
import org.pendant.protocols.toolserial.ToolSerialLine;

/** Option {@code --tool-serial}: what the serial line of the tool connector leads to. */
final class ToolSerialOption {
  static final Option OPTION =
      Option.text("--tool-serial", "DEVICE")
          .documented(
              "/dev/ttyUSB0",
              "the serial device at the tool connector; the run then also listens at port 54321 of"
                  + " 127.0.0.1, and ends with 69 where it cannot, see"
                  + " [tool-communication.md](tool-communication.md)");

  private ToolSerialOption() {}

  /** The device's name, if one is given. */
  static Optional<String> of(Arguments arguments) throws UsageException {
    Optional<String> device = arguments.value(OPTION);
    if (device.isPresent() && device.get().isBlank()) {
      throw new UsageException(text("serialNameEmpty", OPTION.name()));
    }
    return device;
  }

  /** The line to a device, or without one. */
  static ToolSerialLine line(Optional<String> device) {
    return device.map(ToolSerialLine::to).orElseGet(ToolSerialLine::new);
  }
}
