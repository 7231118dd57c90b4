package org.pendant.protocols.modbus;

import java.util.HexFormat;

/** Bytes as they stand in documents: {@code 0001 0000 0006 01 03}. */
final class Hex {
  private Hex() {}

  static byte[] bytes(String text) {
    return HexFormat.of().parseHex(text.replace(" ", ""));
  }

  static String text(byte[] bytes) {
    return HexFormat.of().withUpperCase().formatHex(bytes);
  }
}
