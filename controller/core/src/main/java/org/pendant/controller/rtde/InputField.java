package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import java.util.List;

/**
 * Input field: something that RTDE clients may write.
 *
 * @param name such as {@code input_int_register_3}
 * @param claims under which names a client takes it, so that no other client may write it; see
 *     {@link org.pendant.controller.io.InputOwners}
 */
public record InputField(String name, FieldType type, List<String> claims, Decoder decoder) {
  /** Copies the list. */
  public InputField {
    claims = List.copyOf(claims);
  }

  /** Takes one value out of a package. */
  @FunctionalInterface
  interface Decoder {
    /** Takes {@code type.bytes()} bytes at the buffer's position. */
    void take(ByteBuffer values, InputGathering into);
  }
}
