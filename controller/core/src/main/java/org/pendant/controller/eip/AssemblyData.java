package org.pendant.controller.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Assembly data: the bytes of an assembly at one moment. Immutable; numbers in it are
 * little-endian.
 */
public final class AssemblyData {
  private final byte[] bytes;

  private AssemblyData(byte[] bytes) {
    this.bytes = bytes;
  }

  /** All zero. */
  public static AssemblyData zero(int size) {
    return new AssemblyData(new byte[size]);
  }

  /** A copy of these bytes. */
  public static AssemblyData of(byte[] bytes) {
    return new AssemblyData(bytes.clone());
  }

  /** A copy of what is left in a buffer, which is as it was afterwards. */
  public static AssemblyData of(ByteBuffer buffer) {
    byte[] copy = new byte[buffer.remaining()];
    buffer.duplicate().get(copy);
    return new AssemblyData(copy);
  }

  /** How many bytes there are. */
  public int size() {
    return bytes.length;
  }

  /** A copy of the bytes. */
  public byte[] toArray() {
    return bytes.clone();
  }

  /** The bytes, to be read only. */
  ByteBuffer view() {
    return ByteBuffer.wrap(bytes).asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
  }

  @Override
  public boolean equals(Object other) {
    return other == this
        || (other instanceof AssemblyData data && Arrays.equals(bytes, data.bytes));
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(bytes);
  }
}
