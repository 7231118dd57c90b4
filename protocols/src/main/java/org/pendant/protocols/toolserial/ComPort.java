package org.pendant.protocols.toolserial;

import static org.pendant.protocols.toolserial.ToolSerialTexts.text;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.pendant.controller.external.ToolCommunication;

/** Serial port of this computer. */
final class ComPort implements SerialDevice {
  private static final int DATA_BITS = 8;

  /** How long a read waits, and so how long closing may take, ms. */
  private static final int READ_MS = 100;

  private final SerialPort port;

  private ComPort(SerialPort port) {
    this.port = port;
  }

  /**
   * Opens a device; no other program can open it then.
   *
   * @param name such as {@code /dev/ttyUSB0} or {@code COM3}
   * @throws IOException when that cannot be; the message names the device and says why
   */
  static ComPort open(String name) throws IOException {
    if (name.startsWith("/")) {
      Path file = Path.of(name);
      if (!Files.exists(file)) {
        throw new IOException(text("notThere", name));
      }
      if (!Files.isReadable(file) || !Files.isWritable(file)) {
        throw new IOException(text("noPermission", name));
      }
    }
    SerialLibrary.load();
    try {
      SerialPort port = SerialPort.getCommPort(name);
      port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, READ_MS, 0);
      if (!port.openPort(0)) {
        throw new IOException(text("usedByAnother", name));
      }
      return new ComPort(port);
    } catch (SerialPortInvalidPortException e) {
      throw new IOException(text("noSerialDevice", name), e);
    }
  }

  @Override
  public boolean setUp(ToolCommunication wanted) {
    return port.setComPortParameters(
        wanted.baudRate(), DATA_BITS, stopBits(wanted), parity(wanted.parity()));
  }

  static int stopBits(ToolCommunication wanted) {
    return wanted.stopBits() == 1 ? SerialPort.ONE_STOP_BIT : SerialPort.TWO_STOP_BITS;
  }

  static int parity(ToolCommunication.Parity parity) {
    return switch (parity) {
      case NONE -> SerialPort.NO_PARITY;
      case ODD -> SerialPort.ODD_PARITY;
      case EVEN -> SerialPort.EVEN_PARITY;
    };
  }

  @Override
  public int read(byte[] into, int offset) {
    return port.readBytes(into, into.length - offset, offset);
  }

  @Override
  public int available() {
    return port.bytesAvailable();
  }

  @Override
  public boolean write(byte[] bytes) {
    return port.writeBytes(bytes, bytes.length) == bytes.length;
  }

  @Override
  public void close() {
    port.closePort();
  }
}
