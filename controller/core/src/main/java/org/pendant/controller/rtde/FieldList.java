package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** Collects fields, each with the way its type is written. */
final class FieldList {
  private final Map<String, OutputField> fields;

  FieldList(Map<String, OutputField> fields) {
    this.fields = fields;
  }

  /** A number for each joint. */
  interface OfJoint {
    double value(ControllerState state, int joint);
  }

  /** A code for each joint. */
  interface CodeOfJoint {
    int value(ControllerState state, int joint);
  }

  void add(String name, FieldType type, OutputField.Encoder encoder) {
    if (fields.putIfAbsent(name, new OutputField(name, type, encoder)) != null) {
      throw new IllegalStateException("field " + name + " is declared twice");
    }
  }

  void bool(String name, Predicate<ControllerState> value) {
    add(name, FieldType.BOOL, (state, out) -> out.put((byte) (value.test(state) ? 1 : 0)));
  }

  void uint8(String name, ToIntFunction<ControllerState> value) {
    add(name, FieldType.UINT8, (state, out) -> out.put((byte) value.applyAsInt(state)));
  }

  void uint32(String name, ToIntFunction<ControllerState> bits) {
    add(name, FieldType.UINT32, (state, out) -> out.putInt(bits.applyAsInt(state)));
  }

  void int32(String name, ToIntFunction<ControllerState> value) {
    add(name, FieldType.INT32, (state, out) -> out.putInt(value.applyAsInt(state)));
  }

  /** Bits that fit an int without its sign. */
  void uint64(String name, ToIntFunction<ControllerState> bits) {
    add(
        name,
        FieldType.UINT64,
        (state, out) -> out.putLong(Integer.toUnsignedLong(bits.applyAsInt(state))));
  }

  void number(String name, ToDoubleFunction<ControllerState> value) {
    add(name, FieldType.DOUBLE, (state, out) -> out.putDouble(value.applyAsDouble(state)));
  }

  void joints(String name, Function<ControllerState, Joints> value) {
    add(name, FieldType.VECTOR6D, (state, out) -> put(value.apply(state), out));
  }

  void eachJoint(String name, OfJoint value) {
    add(
        name,
        FieldType.VECTOR6D,
        (state, out) -> {
          for (int i = 0; i < Joints.COUNT; i++) {
            out.putDouble(value.value(state, i));
          }
        });
  }

  void codes(String name, CodeOfJoint value) {
    add(
        name,
        FieldType.VECTOR6INT32,
        (state, out) -> {
          for (int i = 0; i < Joints.COUNT; i++) {
            out.putInt(value.value(state, i));
          }
        });
  }

  void pose(String name, Function<ControllerState, Pose> value) {
    add(name, FieldType.VECTOR6D, (state, out) -> put(value.apply(state), out));
  }

  void wrench(String name, Function<ControllerState, Wrench> value) {
    add(name, FieldType.VECTOR6D, (state, out) -> put(value.apply(state), out));
  }

  /** Three numbers, put by the encoder itself. */
  void vector3(String name, OutputField.Encoder encoder) {
    add(name, FieldType.VECTOR3D, encoder);
  }

  private static void put(Joints q, ByteBuffer out) {
    for (int i = 0; i < Joints.COUNT; i++) {
      out.putDouble(q.get(i));
    }
  }

  private static void put(Pose pose, ByteBuffer out) {
    for (int i = 0; i < Pose.SIZE; i++) {
      out.putDouble(pose.get(i));
    }
  }

  private static void put(Wrench w, ByteBuffer out) {
    out.putDouble(w.fx()).putDouble(w.fy()).putDouble(w.fz());
    out.putDouble(w.mx()).putDouble(w.my()).putDouble(w.mz());
  }
}
