package org.pendant.sweep.table;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;

/** Reads what was written by the specification of the format, not by the writer's code. */
final class ParquetTableTest {
  private static final List<ResultColumn> COLUMNS =
      List.of(
          new ResultColumn("run", CellType.WHOLE, "", "number", _ -> Optional.empty()),
          new ResultColumn("duration", CellType.NUMBER, "s", "time", _ -> Optional.empty()),
          new ResultColumn("reason", CellType.TEXT, "", "why", _ -> Optional.empty()));

  private static byte[] write(List<List<String>> rows) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ParquetTable table = new ParquetTable(out, COLUMNS);
    for (List<String> each : rows) {
      table.add(each);
    }
    table.end();
    return out.toByteArray();
  }

  /** Structures of Thrift's compact protocol, as their fields by number. */
  private static final class Thrift {
    private final ByteBuffer in;

    private Thrift(byte[] bytes, int at) {
      in = ByteBuffer.wrap(bytes);
      in.position(at);
    }

    private long varint() {
      long value = 0;
      for (int shift = 0; ; shift += 7) {
        byte next = in.get();
        value |= (long) (next & 0x7F) << shift;
        if (next >= 0) {
          return value;
        }
      }
    }

    private long integer() {
      long value = varint();
      return value >>> 1 ^ -(value & 1);
    }

    private Map<Integer, Object> struct() {
      Map<Integer, Object> fields = new TreeMap<>();
      int number = 0;
      for (int head = in.get() & 0xFF; head != 0; head = in.get() & 0xFF) {
        number = head >> 4 == 0 ? (int) integer() : number + (head >> 4);
        fields.put(number, value(head & 0xF));
      }
      return fields;
    }

    private Object value(int type) {
      return switch (type) {
        case 5, 6 -> integer();
        case 8 -> {
          byte[] text = new byte[(int) varint()];
          in.get(text);
          yield new String(text, StandardCharsets.UTF_8);
        }
        case 9 -> {
          int head = in.get() & 0xFF;
          int size = head >> 4 == 15 ? (int) varint() : head >> 4;
          List<Object> list = new ArrayList<>();
          for (int i = 0; i < size; i++) {
            list.add(value(head & 0xF));
          }
          yield list;
        }
        case 12 -> struct();
        default -> throw new IllegalArgumentException("type " + type);
      };
    }
  }

  @SuppressWarnings("unchecked")
  private static List<Map<Integer, Object>> structs(Object list) {
    return (List<Map<Integer, Object>>) list;
  }

  @SuppressWarnings("unchecked")
  private static Map<Integer, Object> struct(Object struct) {
    return (Map<Integer, Object>) struct;
  }

  private static Map<Integer, Object> footer(byte[] file) {
    ByteBuffer end = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    int length = end.getInt(file.length - 8);
    return new Thrift(file, file.length - 8 - length).struct();
  }

  /** The values of a column in a group of rows, null where there is none. */
  private static List<Object> values(byte[] file, Map<Integer, Object> chunk) throws IOException {
    Map<Integer, Object> about = struct(chunk.get(3));
    int at = (int) (long) (Long) about.get(9);
    Thrift reader = new Thrift(file, at);
    Map<Integer, Object> header = reader.struct();
    int packed = (int) (long) (Long) header.get(3);
    byte[] page =
        new GZIPInputStream(new ByteArrayInputStream(file, reader.in.position(), packed))
            .readAllBytes();
    assertEquals((Long) header.get(2), page.length);
    ByteBuffer in = ByteBuffer.wrap(page).order(ByteOrder.LITTLE_ENDIAN);
    int levelsEnd = 4 + in.getInt();
    Thrift levels = new Thrift(page, 4);
    List<Boolean> present = new ArrayList<>();
    while (levels.in.position() < levelsEnd) {
      long run = levels.varint() >> 1;
      boolean there = levels.in.get() == 1;
      for (long i = 0; i < run; i++) {
        present.add(there);
      }
    }
    in.position(levelsEnd);
    List<Object> values = new ArrayList<>();
    for (boolean there : present) {
      values.add(there ? value(in, (int) (long) (Long) about.get(1)) : "null");
    }
    assertEquals(0, in.remaining());
    return values;
  }

  private static Object value(ByteBuffer in, int type) {
    if (type == 2) {
      return in.getLong();
    }
    if (type == 5) {
      return in.getDouble();
    }
    byte[] text = new byte[in.getInt()];
    in.get(text);
    return new String(text, StandardCharsets.UTF_8);
  }

  @Test
  void valuesReadBackAsTheyWereWritten() throws IOException {
    byte[] file =
        write(
            List.of(
                List.of("0", "0.1", ""),
                List.of("1", "", "C154 é"),
                List.of("2", "", "x"),
                List.of("3", "-1.0E-5", "")));
    assertArrayEquals("PAR1".getBytes(StandardCharsets.US_ASCII), Arrays.copyOf(file, 4));
    assertArrayEquals(
        "PAR1".getBytes(StandardCharsets.US_ASCII),
        Arrays.copyOfRange(file, file.length - 4, file.length));
    Map<Integer, Object> footer = footer(file);
    assertEquals(4L, footer.get(3));
    List<Map<Integer, Object>> schema = structs(footer.get(2));
    assertEquals(
        List.of("results", "run", "duration", "reason"),
        schema.stream().map(each -> each.get(4)).toList());
    List<Map<Integer, Object>> chunks = structs(structs(footer.get(4)).getFirst().get(1));
    assertEquals(List.of(0L, 1L, 2L, 3L), values(file, chunks.get(0)));
    assertEquals(List.of(0.1, "null", "null", -1e-5), values(file, chunks.get(1)));
    assertEquals(List.of("", "C154 é", "x", ""), values(file, chunks.get(2)));
    assertEquals("time, s", structs(footer.get(5)).get(1).get(2));
  }

  @Test
  void manyRowsAreInSeveralGroups() throws IOException {
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < 45_000; i++) {
      rows.add(List.of(Integer.toString(i), i % 3 == 0 ? "" : i + ".5", "r" + i % 7));
    }
    byte[] file = write(rows);
    List<Map<Integer, Object>> groups = structs(footer(file).get(4));
    assertEquals(
        List.of(20_000L, 20_000L, 5_000L), groups.stream().map(each -> each.get(3)).toList());
    List<Object> last = values(file, structs(groups.get(2).get(1)).get(1));
    assertEquals("null", last.get(2));
    assertEquals(44_999.5, last.getLast());
    assertArrayEquals(file, write(rows));
  }
}
