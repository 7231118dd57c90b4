package org.pendant.protocols.realtime;

import java.nio.ByteOrder;
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

  private final PacketLayout layout;

  RealtimeCodec() {
    PacketLayout.Builder packet =
        new PacketLayout.Builder(BYTES, ByteOrder.BIG_ENDIAN).int32(BYTES);
    put(
        packet,
        "timestamp",
        "target_q",
        "target_qd",
        "target_qdd",
        "target_current",
        "target_torque");
    put(packet, "actual_q", "actual_qd", "current", "current");
    put(packet, "actual_tcp", "tcp_velocity", "tcp_wrench", "target_tcp", "target_tcp_velocity");
    put(packet, "digital_input_bits", "temperature", "execution_time");
    reserved(packet, 1);
    put(packet, "robot_mode", "joint_mode", "safety_mode");
    reserved(packet, 6);
    put(packet, "tool_acceleration");
    reserved(packet, 6);
    put(packet, "speed_scaling", "momentum");
    reserved(packet, 2);
    put(
        packet,
        "main_voltage",
        "robot_voltage",
        "robot_current",
        "joint_voltage",
        "digital_output_bits");
    put(packet, "runtime_state", "elbow", "elbow_speed", "safety_status");
    reserved(packet, 3);
    put(packet, "payload", "payload_cog", "payload_inertia");
    layout = packet.build();
  }

  private static void put(PacketLayout.Builder packet, String... quantities) {
    packet.put(WireType.FLOAT64, quantities);
  }

  /** Doubles whose meaning is not published. */
  private static void reserved(PacketLayout.Builder packet, int count) {
    packet.skip(count * Double.BYTES);
  }

  /** The package of a frame. */
  byte[] encode(ControllerState state) {
    return layout.encode(state);
  }
}
