package org.pendant.protocols.toolserial;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** Serial devices of this computer. */
public final class SerialDevices {
  private SerialDevices() {}

  /**
   * A device.
   *
   * @param name by which it is opened, such as {@code /dev/ttyUSB0} or {@code COM3}
   * @param description in the words of its driver
   * @param permitted whether this user may read and write it
   */
  public record Found(String name, String description, boolean permitted) {}

  /**
   * All that there are, without opening one.
   *
   * @throws IOException when serial devices cannot be used on this computer
   */
  public static List<Found> all() throws IOException {
    SerialLibrary.load();
    return Arrays.stream(SerialPort.getCommPorts()).map(SerialDevices::found).toList();
  }

  private static Found found(SerialPort port) {
    String name = port.getSystemPortPath();
    Path file = Path.of(name.startsWith("/") ? name : ".");
    return new Found(
        name, port.getPortDescription(), Files.isReadable(file) && Files.isWritable(file));
  }
}
