package org.pendant.sweep.table;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Writer of structures in Thrift's compact protocol, of which the headers and the footer of a
 * Parquet file are (https://github.com/apache/thrift, doc/specs/thrift-compact-protocol.md).
 */
final class CompactThrift {
  private static final int I32 = 5;
  private static final int I64 = 6;
  private static final int BINARY = 8;
  private static final int LIST = 9;
  private static final int STRUCT = 12;
  private static final int SHORT_LIST = 15;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final int[] lastFields = new int[16];
  private int depth;

  private void field(int number, int type) {
    int step = number - lastFields[depth];
    if (step > 0 && step <= SHORT_LIST) {
      out.write((step << 4) | type);
    } else {
      out.write(type);
      varint(zigzag(number));
    }
    lastFields[depth] = number;
  }

  private static long zigzag(long number) {
    return (number << 1) ^ (number >> 63);
  }

  private void varint(long number) {
    long rest = number;
    while ((rest & ~0x7FL) != 0) {
      out.write((int) ((rest & 0x7F) | 0x80));
      rest >>>= 7;
    }
    out.write((int) rest);
  }

  CompactThrift i32(int field, int value) {
    field(field, I32);
    varint(zigzag(value));
    return this;
  }

  CompactThrift i64(int field, long value) {
    field(field, I64);
    varint(zigzag(value));
    return this;
  }

  CompactThrift text(int field, String value) {
    field(field, BINARY);
    bytes(value);
    return this;
  }

  private void bytes(String value) {
    byte[] bytes = value.getBytes(StandardCharsets.UTF_8);
    varint(bytes.length);
    out.writeBytes(bytes);
  }

  /** Begins a structure in a field. */
  CompactThrift begin(int field) {
    field(field, STRUCT);
    return element();
  }

  /** Begins a structure in a list. */
  CompactThrift element() {
    depth++;
    lastFields[depth] = 0;
    return this;
  }

  /** Ends a structure that was begun. */
  CompactThrift end() {
    out.write(0);
    depth--;
    return this;
  }

  /** Begins a list of structures, which follow as elements. */
  CompactThrift structs(int field, int size) {
    list(field, size, STRUCT);
    return this;
  }

  CompactThrift integers(int field, int... values) {
    list(field, values.length, I32);
    for (int each : values) {
      varint(zigzag(each));
    }
    return this;
  }

  CompactThrift texts(int field, String... values) {
    list(field, values.length, BINARY);
    for (String each : values) {
      bytes(each);
    }
    return this;
  }

  private void list(int field, int size, int type) {
    field(field, LIST);
    if (size < SHORT_LIST) {
      out.write((size << 4) | type);
    } else {
      out.write((SHORT_LIST << 4) | type);
      varint(size);
    }
  }

  /** All of it, as a structure that has ended. */
  byte[] toBytes() {
    out.write(0);
    return out.toByteArray();
  }
}
