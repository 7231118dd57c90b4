package org.pendant.protocols.server;

import java.math.BigInteger;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.Optional;

/** Address row: addresses that follow one another, one for each of several robots. */
public final class AddressRow {
  private AddressRow() {}

  /**
   * The address that follows {@code first} after {@code steps}; empty after the last there is, and
   * where {@code first} stands for all interfaces.
   */
  public static Optional<InetAddress> after(InetAddress first, int steps) {
    byte[] bytes = first.getAddress();
    BigInteger following = new BigInteger(1, bytes).add(BigInteger.valueOf(steps));
    if (first.isAnyLocalAddress() || following.bitLength() > Byte.SIZE * bytes.length) {
      return Optional.empty();
    }
    byte[] digits = following.toByteArray();
    Arrays.fill(bytes, (byte) 0);
    int length = Math.min(digits.length, bytes.length);
    System.arraycopy(digits, digits.length - length, bytes, bytes.length - length, length);
    try {
      return Optional.of(InetAddress.getByAddress(bytes));
    } catch (UnknownHostException e) {
      throw new IllegalStateException("the address has as many bytes as the first", e);
    }
  }
}
