package org.pendant.protocols.primary;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariableSample;

/**
 * Variable packages: global variables as bytes, big-endian: {@code i32 size, u8 25, u64 time, i8
 * part, u16 first variable}, then names or values with a line end after each. Where there are many,
 * several packages follow each other.
 */
final class VariablePackages {
  /** A package that some clients still take; one variable alone may be longer. */
  static final int USUAL_BYTES = 1900;

  private static final int HEADER = 16;
  static final byte PROGRAM_STATE = 25;
  static final byte SETUP = 0;
  static final byte UPDATE = 1;
  private static final byte LINE_END = '\n';

  private VariablePackages() {}

  /** Nothing has changed. */
  static byte[] empty() {
    return begin(RobotMessage.BEFORE, UPDATE, 0, 0).array();
  }

  /** The names of all variables. */
  static List<byte[]> setup(long timeUs, List<VariableSample> variables) {
    List<byte[]> names =
        variables.stream().map(each -> each.name().getBytes(StandardCharsets.ISO_8859_1)).toList();
    return packages(timeUs, SETUP, names);
  }

  /** The values of all variables, in the same order. */
  static List<byte[]> update(long timeUs, List<VariableSample> variables) {
    List<byte[]> values = new ArrayList<>();
    for (VariableSample variable : variables) {
      values.add(variable.value().map(VariablePackages::encoded).orElseGet(ValueCodec::none));
    }
    return packages(timeUs, UPDATE, values);
  }

  private static byte[] encoded(Value value) {
    return ValueCodec.encode(value);
  }

  private static List<byte[]> packages(long timeUs, byte part, List<byte[]> entries) {
    List<byte[]> packages = new ArrayList<>();
    ByteArrayOutputStream body = new ByteArrayOutputStream();
    int first = 0;
    for (int i = 0; i < entries.size(); i++) {
      byte[] entry = entries.get(i);
      if (i > first && HEADER + body.size() + entry.length + 1 > USUAL_BYTES) {
        packages.add(whole(timeUs, part, first, body));
        body.reset();
        first = i;
      }
      body.writeBytes(entry);
      body.write(LINE_END);
    }
    packages.add(whole(timeUs, part, first, body));
    return packages;
  }

  private static byte[] whole(long timeUs, byte part, int first, ByteArrayOutputStream body) {
    return begin(timeUs, part, first, body.size()).put(body.toByteArray()).array();
  }

  private static ByteBuffer begin(long timeUs, byte part, int first, int bodyBytes) {
    return ByteBuffer.allocate(HEADER + bodyBytes)
        .putInt(HEADER + bodyBytes)
        .put(PROGRAM_STATE)
        .putLong(timeUs)
        .put(part)
        .putShort((short) first);
  }
}
