package org.pendant.recording;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.script.variables.VariableSamples;

/**
 * Byte sink: the bytes of one block as they are written; numbers are little-endian, whole ones of
 * any length.
 */
final class ByteSink {
  /** Longer texts are written each time. */
  static final int MAX_KNOWN_LENGTH = 200;

  /** So many texts are told once and then called by number. */
  static final int MAX_KNOWN_NAMES = 10_000;

  private byte[] bytes = new byte[1 << 16];
  private int size;
  private final Map<String, Integer> known = new HashMap<>();
  private List<String> tracedNames = List.of();
  private VariableSamples samples = VariableSamples.NONE;

  byte[] array() {
    return bytes;
  }

  int size() {
    return size;
  }

  private int grow(int more) {
    int at = size;
    size = Math.addExact(size, more);
    if (size > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(size, 2 * bytes.length));
    }
    return at;
  }

  void byteOf(int value) {
    int at = grow(1);
    bytes[at] = (byte) value;
  }

  void bool(boolean value) {
    byteOf(value ? 1 : 0);
  }

  /** A whole number of at least 0: seven bits a byte, the lowest first. */
  void unsigned(long value) {
    long left = value;
    while ((left & ~0x7FL) != 0) {
      byteOf((int) ((left & 0x7F) | 0x80));
      left >>>= 7;
    }
    byteOf((int) left);
  }

  void count(int value) {
    unsigned(value);
  }

  /** A whole number with a sign, which stands in the lowest bit. */
  void whole(long value) {
    unsigned((value << 1) ^ (value >> 63));
  }

  /** Eight bytes. */
  void longOf(long value) {
    int at = grow(Long.BYTES);
    for (int i = 0; i < Long.BYTES; i++) {
      bytes[at + i] = (byte) (value >>> (8 * i));
    }
  }

  /** All 64 bits. */
  void number(double value) {
    longOf(Double.doubleToRawLongBits(value));
  }

  void raw(byte[] value) {
    int at = grow(value.length);
    System.arraycopy(value, 0, bytes, at, value.length);
  }

  /** The constant's name, so that constants may be added between others. */
  void constant(Enum<?> value) {
    text(value.name());
  }

  /** 0 and a new text, or the number of one that was written before, from 1. */
  void text(String value) {
    Integer number = known.get(value);
    if (number != null) {
      unsigned(number);
      return;
    }
    byteOf(0);
    byte[] encoded = value.getBytes(StandardCharsets.UTF_8);
    count(encoded.length);
    raw(encoded);
    if (value.length() <= MAX_KNOWN_LENGTH && known.size() < MAX_KNOWN_NAMES) {
      known.put(value, known.size() + 1);
    }
  }

  /** The samples before, whose unchanged variables are not written again. */
  VariableSamples samplesBefore(VariableSamples now) {
    VariableSamples before = samples;
    samples = now;
    return before;
  }

  /** Whether these names are those that were written last. */
  boolean tracedBefore(List<String> now) {
    boolean same = tracedNames.equals(now);
    tracedNames = now;
    return same;
  }
}
