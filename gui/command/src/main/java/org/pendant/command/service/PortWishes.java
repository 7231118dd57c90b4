package org.pendant.command.service;

import java.nio.file.Path;
import java.util.OptionalInt;
import org.pendant.protocols.toolserial.ToolSerialServer;

/**
 * Port wishes: how clients shall reach the controller.
 *
 * @param host address or name of the interface to listen at
 * @param offset is added to every standard port, 0 to {@link #MAX_OFFSET}
 * @param modbus port of Modbus; empty for 502 and the offset, or 1000 more where the system does
 *     not allow that
 * @param programs folder of the programs that clients load
 * @param remote whether they may control the robot, or only ask
 */
public record PortWishes(
    String host, int offset, OptionalInt modbus, Path programs, boolean remote) {
  /** The address that only this computer reaches. */
  public static final String STANDARD_HOST = "127.0.0.1";

  /** The largest number of a port. */
  public static final int MAX_PORT = 65_535;

  /** The largest port, that of the tool's serial line, must still be one. */
  public static final int MAX_OFFSET = MAX_PORT - ToolSerialServer.STANDARD_PORT;

  /** The same, with another choice between remote and local control. */
  public PortWishes withRemote(boolean allowed) {
    return new PortWishes(host, offset, modbus, programs, allowed);
  }

  /** Reads a whole number; empty if it is none from {@code least} to {@code most}. */
  public static OptionalInt number(String text, int least, int most) {
    try {
      int number = Integer.parseInt(text.strip());
      return number >= least && number <= most ? OptionalInt.of(number) : OptionalInt.empty();
    } catch (NumberFormatException e) {
      return OptionalInt.empty();
    }
  }
}
