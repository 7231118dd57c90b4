package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import org.pendant.controller.state.ControllerState;

/**
 * Something about the controller that RTDE clients may ask for by its name, and programs with
 * {@code get_rtde_value} (manual 18.10).
 *
 * @param name such as {@code actual_q}
 * @param encoder puts its value, {@code type.bytes()} bytes, into a big-endian buffer
 */
public record OutputField(String name, FieldType type, Encoder encoder) {

  /** Puts one value of a snapshot into a buffer. */
  @FunctionalInterface
  public interface Encoder {
    /** Puts the value at the buffer's position. */
    void put(ControllerState state, ByteBuffer out);
  }
}
