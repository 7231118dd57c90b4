package org.pendant.protocols.realtime;

import java.nio.ByteBuffer;
import org.pendant.controller.rtde.FieldType;
import org.pendant.controller.rtde.OutputField;
import org.pendant.controller.rtde.OutputFields;
import org.pendant.controller.state.ControllerState;

/**
 * An output field of the controller as plain numbers, whatever its type. Only one thread at a time
 * uses an object.
 */
final class FieldNumbers {
  private static final int MAX_BYTES = 48;

  private final OutputField field;
  private final ByteBuffer scratch = ByteBuffer.allocate(MAX_BYTES);

  /**
   * The field called {@code name}.
   *
   * @throws IllegalArgumentException if there is none
   */
  FieldNumbers(String name) {
    field =
        OutputFields.of(name)
            .orElseThrow(() -> new IllegalArgumentException("there is no output field " + name));
  }

  /** How many numbers it has. */
  int count() {
    return switch (field.type()) {
      case BOOL, UINT8, UINT32, UINT64, INT32, DOUBLE -> 1;
      case VECTOR3D -> 3;
      case VECTOR6D, VECTOR6INT32, VECTOR6UINT32 -> 6;
    };
  }

  /** Looks at a snapshot; {@link #number} answers for it then. */
  FieldNumbers in(ControllerState state) {
    scratch.clear();
    field.encoder().put(state, scratch);
    return this;
  }

  /**
   * Number {@code index} in the snapshot that was looked at.
   *
   * @param index 0 to {@link #count} - 1
   */
  double number(int index) {
    FieldType type = field.type();
    return switch (type) {
      case BOOL, UINT8 -> scratch.get(0) & 0xFF;
      case UINT32 -> scratch.getInt(0) & 0xFFFF_FFFFL;
      case UINT64 -> scratch.getLong(0);
      case INT32 -> scratch.getInt(0);
      case DOUBLE, VECTOR3D, VECTOR6D -> scratch.getDouble(Double.BYTES * index);
      case VECTOR6INT32 -> scratch.getInt(Integer.BYTES * index);
      case VECTOR6UINT32 -> scratch.getInt(Integer.BYTES * index) & 0xFFFF_FFFFL;
    };
  }
}
