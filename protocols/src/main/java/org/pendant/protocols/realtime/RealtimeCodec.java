package org.pendant.protocols.realtime;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.state.ControllerState;

/**
 * The package of version 5.10 and later, big-endian: {@code i32 size}, then 152 doubles. The same
 * quantities as output fields, in a fixed order; whole numbers and bits are doubles as well. Only
 * one thread at a time uses an object.
 */
final class RealtimeCodec {
  /** Bytes of a package. */
  static final int BYTES = 1220;

  /**
   * Some doubles in a row.
   *
   * @param field what they are; empty for 0, where nobody outside knows what is meant
   */
  private record Slots(Optional<FieldNumbers> field, int count) {}

  private final List<Slots> layout = new ArrayList<>();

  RealtimeCodec() {
    fields("timestamp", "target_q", "target_qd", "target_qdd", "target_current", "target_moment");
    fields("actual_q", "actual_qd", "actual_current", "joint_control_output");
    fields("actual_TCP_pose", "actual_TCP_speed", "actual_TCP_force");
    fields("target_TCP_pose", "target_TCP_speed");
    fields("actual_digital_input_bits", "joint_temperatures", "actual_execution_time");
    reserved(1);
    fields("robot_mode", "joint_mode", "safety_mode");
    reserved(6);
    fields("actual_tool_accelerometer");
    reserved(6);
    fields("speed_scaling", "actual_momentum");
    reserved(2);
    fields("actual_main_voltage", "actual_robot_voltage", "actual_robot_current");
    fields("actual_joint_voltage", "actual_digital_output_bits", "runtime_state");
    fields("elbow_position", "elbow_velocity", "safety_status");
    reserved(3);
    fields("payload", "payload_cog", "payload_inertia");
  }

  private void fields(String... names) {
    for (String name : names) {
      FieldNumbers field = new FieldNumbers(name);
      layout.add(new Slots(Optional.of(field), field.count()));
    }
  }

  private void reserved(int count) {
    layout.add(new Slots(Optional.empty(), count));
  }

  /** The package of a frame. */
  byte[] encode(ControllerState state) {
    ByteBuffer out = ByteBuffer.allocate(BYTES).putInt(BYTES);
    for (Slots slots : layout) {
      if (slots.field().isPresent()) {
        FieldNumbers numbers = slots.field().get().in(state);
        for (int i = 0; i < slots.count(); i++) {
          out.putDouble(numbers.number(i));
        }
      } else {
        out.position(out.position() + slots.count() * Double.BYTES);
      }
    }
    return out.array();
  }
}
