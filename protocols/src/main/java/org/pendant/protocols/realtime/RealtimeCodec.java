package org.pendant.protocols.realtime;

import java.nio.ByteOrder;
import java.util.List;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.packet.PacketLayout;
import org.pendant.protocols.packet.WireType;

/**
 * Real-time codec: the package of version 5.10 and later, big-endian: {@code i32 size}, then 152
 * doubles. The same quantities as output fields, in a fixed order; whole numbers and bits are
 * doubles as well. Only one thread at a time uses an object.
 */
final class RealtimeCodec {
  /** Bytes of a package. */
  static final int BYTES = 1220;

  /** What follows the size, in its order. */
  static final List<Part> PARTS =
      List.of(
          new Quantity("timestamp"),
          new Quantity("target_q"),
          new Quantity("target_qd"),
          new Quantity("target_qdd"),
          new Quantity("target_current"),
          new Quantity("target_torque"),
          new Quantity("actual_q"),
          new Quantity("actual_qd"),
          new Quantity("current"),
          new Quantity("current"),
          new Quantity("actual_tcp"),
          new Quantity("tcp_velocity"),
          new Quantity("tcp_wrench"),
          new Quantity("target_tcp"),
          new Quantity("target_tcp_velocity"),
          new Quantity("digital_input_bits"),
          new Quantity("temperature"),
          new Quantity("execution_time"),
          new Reserved(1),
          new Quantity("robot_mode"),
          new Quantity("joint_mode"),
          new Quantity("safety_mode"),
          new Reserved(6),
          new Quantity("tool_acceleration"),
          new Reserved(6),
          new Quantity("speed_scaling"),
          new Quantity("momentum"),
          new Reserved(2),
          new Quantity("main_voltage"),
          new Quantity("robot_voltage"),
          new Quantity("robot_current"),
          new Quantity("joint_voltage"),
          new Quantity("digital_output_bits"),
          new Quantity("runtime_state"),
          new Quantity("elbow"),
          new Quantity("elbow_speed"),
          new Quantity("safety_status"),
          new Reserved(3),
          new Quantity("payload"),
          new Quantity("payload_cog"),
          new Quantity("payload_inertia"));

  private final PacketLayout layout;

  /** A part of the package. */
  sealed interface Part {}

  /** The components of a state quantity. */
  record Quantity(String name) implements Part {}

  /** Doubles whose meaning is not published. */
  record Reserved(int count) implements Part {}

  RealtimeCodec() {
    PacketLayout.Builder packet =
        new PacketLayout.Builder(BYTES, ByteOrder.BIG_ENDIAN).int32(BYTES);
    for (Part part : PARTS) {
      switch (part) {
        case Quantity quantity -> packet.put(WireType.FLOAT64, quantity.name());
        case Reserved reserved -> packet.skip(reserved.count() * Double.BYTES);
      }
    }
    layout = packet.build();
  }

  /** The package of a frame. */
  byte[] encode(ControllerState state) {
    return layout.encode(state);
  }
}
