package org.pendant.controller.rtde;

import org.pendant.controller.quantity.ScalarType;

/** The type of a field that is exchanged by RTDE; values are big-endian and lie close together. */
public enum FieldType {
  BOOL(1),
  UINT8(1),
  UINT32(4),
  UINT64(8),
  INT32(4),
  DOUBLE(8),
  VECTOR3D(24),
  VECTOR6D(48),
  VECTOR6INT32(24),
  VECTOR6UINT32(24);

  private final int bytes;

  FieldType(int bytes) {
    this.bytes = bytes;
  }

  /** How many bytes a value takes. */
  public int bytes() {
    return bytes;
  }

  /**
   * The type of {@code count} numbers.
   *
   * @throws IllegalArgumentException if the interface has none
   */
  static FieldType of(ScalarType scalar, int count) {
    return switch (count) {
      case 1 ->
          switch (scalar) {
            case BOOL -> BOOL;
            case UINT8 -> UINT8;
            case INT32 -> INT32;
            case UINT32 -> UINT32;
            case UINT64 -> UINT64;
            case DOUBLE -> DOUBLE;
          };
      case 3 -> VECTOR3D;
      case 6 -> scalar == ScalarType.INT32 ? VECTOR6INT32 : VECTOR6D;
      default ->
          throw new IllegalArgumentException("a field has " + count + " numbers, must be 1, 3, 6");
    };
  }
}
