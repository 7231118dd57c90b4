package org.pendant.protocols.toolserial;

import java.io.IOException;
import org.pendant.controller.external.ToolCommunication;

/** Serial device that is open. */
interface SerialDevice extends AutoCloseable {
  /** Opens a device. */
  @FunctionalInterface
  interface Opening {
    /**
     * Opens it, with whatever speed it has.
     *
     * @throws IOException when that cannot be; the message names the device and says why
     */
    SerialDevice open() throws IOException;
  }

  /**
   * Sets speed, parity and stop bits.
   *
   * @return whether the device can do that
   */
  boolean setUp(ToolCommunication wanted);

  /**
   * Waits a moment for bytes.
   *
   * @return how many have come, 0 for none in this moment, negative when the device is gone
   */
  int read(byte[] into, int offset);

  /** How many bytes have come that were not read; negative when the device is gone. */
  int available();

  /**
   * Writes all of {@code bytes}; waits for the device.
   *
   * @return whether it took them
   */
  boolean write(byte[] bytes);

  @Override
  void close();
}
