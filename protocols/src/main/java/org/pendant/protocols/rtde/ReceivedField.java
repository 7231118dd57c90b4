package org.pendant.protocols.rtde;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.IntStream;
import org.pendant.controller.rtde.FieldType;

/**
 * Received field: a field that a controller sends, and its place in a table.
 *
 * @param name such as {@code actual_q}
 * @param type of its value
 */
public record ReceivedField(String name, FieldType type) {

  /** How many numbers a value has. */
  public int count() {
    return switch (type) {
      case BOOL, UINT8, UINT32, UINT64, INT32, DOUBLE -> 1;
      case VECTOR3D -> 3;
      case VECTOR6D, VECTOR6INT32, VECTOR6UINT32 -> 6;
    };
  }

  /** The headings of its columns: its name, or {@code actual_q_0} and so on. */
  public List<String> columns() {
    return count() == 1
        ? List.of(name)
        : IntStream.range(0, count()).mapToObj(i -> name + "_" + i).toList();
  }

  /**
   * Reads a value as numbers: 1 and 0 for true and false.
   *
   * @param data from which the value is taken
   * @param numbers gets {@link #count} of them
   * @param at the place of the first
   */
  public void read(ByteBuffer data, double[] numbers, int at) {
    for (int i = 0; i < count(); i++) {
      numbers[at + i] =
          switch (type) {
            case BOOL -> data.get() != 0 ? 1 : 0;
            case UINT8 -> Byte.toUnsignedInt(data.get());
            case UINT32, VECTOR6UINT32 -> Integer.toUnsignedLong(data.getInt());
            case UINT64 -> data.getLong();
            case INT32, VECTOR6INT32 -> data.getInt();
            case DOUBLE, VECTOR3D, VECTOR6D -> data.getDouble();
          };
    }
  }

  /**
   * Writes a value as the cells of a row: numbers that read back as the same, and {@code True} or
   * {@code False}.
   *
   * @param data from which the value is taken
   * @param separator stands between cells
   */
  public void append(ByteBuffer data, char separator, StringBuilder row) {
    for (int i = 0; i < count(); i++) {
      if (i > 0) {
        row.append(separator);
      }
      switch (type) {
        case BOOL -> row.append(data.get() != 0 ? "True" : "False");
        case UINT8 -> row.append(Byte.toUnsignedInt(data.get()));
        case UINT32, VECTOR6UINT32 -> row.append(Integer.toUnsignedString(data.getInt()));
        case UINT64 -> row.append(Long.toUnsignedString(data.getLong()));
        case INT32, VECTOR6INT32 -> row.append(data.getInt());
        case DOUBLE, VECTOR3D, VECTOR6D -> row.append(data.getDouble());
      }
    }
  }
}
