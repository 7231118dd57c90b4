package org.pendant.recording;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSamples;

/**
 * Byte source: reads what {@link ByteSink} wrote. Nothing is believed: every count is compared with
 * what is left of the block before anything of that size is made.
 */
final class ByteSource {
  /** Values in values; deeper ones are no recording's. */
  private static final int DEEPEST = 1000;

  private final ByteBuffer bytes;
  private final List<String> known = new ArrayList<>();
  private TracedVariables traced = TracedVariables.NONE;
  private VariableSamples samples = VariableSamples.NONE;
  private int depth;

  ByteSource(byte[] block) {
    bytes = ByteBuffer.wrap(block).order(ByteOrder.LITTLE_ENDIAN);
  }

  int left() {
    return bytes.remaining();
  }

  private void need(int count) throws MalformedBytes {
    if (count > bytes.remaining()) {
      throw new MalformedBytes(RecordingTexts.text("bytesAnnounced", count, bytes.remaining()));
    }
  }

  int byteOf() throws MalformedBytes {
    need(1);
    return bytes.get() & 0xFF;
  }

  boolean bool() throws MalformedBytes {
    int value = byteOf();
    if (value > 1) {
      throw new MalformedBytes(RecordingTexts.text("truthValue", value));
    }
    return value == 1;
  }

  long unsigned() throws MalformedBytes {
    long value = 0;
    for (int shift = 0; shift < Long.SIZE; shift += 7) {
      int next = byteOf();
      value |= (long) (next & 0x7F) << shift;
      if ((next & 0x80) == 0) {
        return value;
      }
    }
    throw new MalformedBytes(RecordingTexts.text("endlessNumber"));
  }

  long whole() throws MalformedBytes {
    long value = unsigned();
    return (value >>> 1) ^ -(value & 1);
  }

  /** A whole number of 32 bits. */
  int integer() throws MalformedBytes {
    long value = whole();
    if (value != (int) value) {
      throw new MalformedBytes(RecordingTexts.text("numberNot32Bits", value));
    }
    return (int) value;
  }

  /** A whole number of 0 to {@code most}. */
  int upTo(int most) throws MalformedBytes {
    long value = unsigned();
    if (value < 0 || value > most) {
      throw new MalformedBytes(RecordingTexts.text("numberOutside", value, most));
    }
    return (int) value;
  }

  /** How many things follow, of which each takes at least {@code leastBytes}. */
  int count(int leastBytes) throws MalformedBytes {
    long value = unsigned();
    if (value < 0 || value > bytes.remaining() / leastBytes) {
      throw new MalformedBytes(RecordingTexts.text("thingsAnnounced", value, bytes.remaining()));
    }
    return (int) value;
  }

  long longOf() throws MalformedBytes {
    need(Long.BYTES);
    return bytes.getLong();
  }

  double number() throws MalformedBytes {
    return Double.longBitsToDouble(longOf());
  }

  byte[] raw(int count) throws MalformedBytes {
    need(count);
    byte[] read = new byte[count];
    bytes.get(read);
    return read;
  }

  <E extends Enum<E>> E constant(Class<E> type) throws MalformedBytes {
    String name = text();
    try {
      return Enum.valueOf(type, name);
    } catch (IllegalArgumentException e) {
      throw new MalformedBytes(
          RecordingTexts.text("noConstant", shown(name), type.getSimpleName()));
    }
  }

  private static String shown(String name) {
    return name.length() > 40 ? name.substring(0, 40) + "..." : name;
  }

  String text() throws MalformedBytes {
    long number = unsigned();
    if (number != 0) {
      if (number < 0 || number > known.size()) {
        throw new MalformedBytes(RecordingTexts.text("noSuchText", number, known.size()));
      }
      return known.get((int) number - 1);
    }
    String text = new String(raw(count(1)), StandardCharsets.UTF_8);
    if (text.length() <= ByteSink.MAX_KNOWN_LENGTH && known.size() < ByteSink.MAX_KNOWN_NAMES) {
      known.add(text);
    }
    return text;
  }

  VariableSamples samplesBefore() {
    return samples;
  }

  void keep(VariableSamples now) {
    samples = now;
  }

  TracedVariables tracedBefore() {
    return traced;
  }

  void keep(TracedVariables now) {
    traced = now;
  }

  /** Into a value in a value. */
  void deeper() throws MalformedBytes {
    depth++;
    if (depth > DEEPEST) {
      throw new MalformedBytes(RecordingTexts.text("nestedTooDeep", DEEPEST));
    }
  }

  /** Out of it again. */
  void shallower() {
    depth--;
  }
}
