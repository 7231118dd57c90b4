package org.pendant.protocols.primary;

import static org.pendant.protocols.packet.WireType.FLOAT32;
import static org.pendant.protocols.packet.WireType.FLOAT64;
import static org.pendant.protocols.packet.WireType.INT32;
import static org.pendant.protocols.packet.WireType.INT64;
import static org.pendant.protocols.packet.WireType.INT8;

import java.nio.ByteOrder;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.protocols.packet.PacketLayout;

/**
 * Robot state codec: the state as bytes, big-endian: {@code i32 size, u8 16}, then parts of {@code
 * u32 size, u8 type} and a body each. Only one thread at a time uses an object.
 */
final class RobotStateCodec {
  static final int PERIODIC_BYTES = 716;
  static final int FULL_BYTES =
      PERIODIC_BYTES + ConfigurationParts.KINEMATICS_BYTES + ConfigurationParts.CONFIGURATION_BYTES;

  private static final byte ROBOT_STATE = 16;
  private static final byte TRUE = 1;
  private static final byte FALSE = 0;

  /** How far the speed slider may go. */
  private static final double SPEED_LIMIT = 1;

  /** What a real box says in places of which only its maker knows the meaning. */
  private static final byte OPERATIONAL_MODE_INPUT = 1;

  private static final byte ENABLING_DEVICE_INPUT = 1;
  private static final byte MASTERBOARD_END = 1;
  private static final byte ADDITIONAL_END = 1;
  private static final double SAFETY_END = 0.13;

  private final PacketLayout full;
  private final PacketLayout periodic;

  RobotStateCodec(ArmDescription arm) {
    full =
        layout(
            FULL_BYTES, ConfigurationParts.kinematics(arm), ConfigurationParts.configuration(arm));
    periodic = layout(PERIODIC_BYTES, new byte[0], new byte[0]);
  }

  /** With kinematics and configuration. */
  byte[] full(ControllerState state) {
    return full.encode(state);
  }

  /** What changes all the time. */
  byte[] periodic(ControllerState state) {
    return periodic.encode(state);
  }

  private static PacketLayout layout(int bytes, byte[] kinematics, byte[] configuration) {
    PacketLayout.Builder packet =
        new PacketLayout.Builder(bytes, ByteOrder.BIG_ENDIAN).int32(bytes).bytes(ROBOT_STATE);
    addRobotMode(packet);
    addJoints(packet);
    begin(packet, 101, 4).put(FLOAT64, "actual_tcp", "tcp_offset").bytes(kinematics);
    // calibration data, which is not published
    begin(packet, 53, 9).skip(48);
    addMasterboard(packet);
    addTool(packet);
    packet.bytes(configuration);
    begin(packet, 61, 7).put(FLOAT64, "tcp_wrench", "dexterity");
    begin(packet, 9, 8).bytes(FALSE, TRUE).put(INT8, "freedrive_input").bytes(ADDITIONAL_END);
    begin(packet, 43, 10)
        .put(INT32, "safety_checksum")
        .bytes(TRUE, TRUE)
        .put(FLOAT64, "elbow")
        .float64(SAFETY_END);
    addSerialLine(packet);
    begin(packet, 8, 12).put(INT8, "tool_output_mode", "tool_pin_mode");
    return packet.build();
  }

  private static PacketLayout.Builder begin(PacketLayout.Builder packet, int size, int type) {
    return packet.int32(size).bytes((byte) type);
  }

  private static void addRobotMode(PacketLayout.Builder packet) {
    begin(packet, 47, 0)
        .put(INT64, EventMessages::timeUs)
        .bytes(TRUE, TRUE)
        .put(INT8, "power_on", "emergency_stopped", "protective_stopped")
        .put(INT8, "program_running", "program_paused", "robot_mode", "control_mode")
        .put(FLOAT64, "speed_slider", "speed_scaling")
        .float64(SPEED_LIMIT)
        .bytes(FALSE);
  }

  private static void addJoints(PacketLayout.Builder packet) {
    begin(packet, 251, 1);
    for (int i = 0; i < Joints.COUNT; i++) {
      packet
          .put(FLOAT64, StateQuantities.of("actual_q"), i, 1)
          .put(FLOAT64, StateQuantities.of("target_q"), i, 1)
          .put(FLOAT64, StateQuantities.of("actual_qd"), i, 1)
          .put(FLOAT32, StateQuantities.of("current"), i, 1)
          .put(FLOAT32, StateQuantities.of("joint_voltage"), i, 1)
          .put(FLOAT32, StateQuantities.of("temperature"), i, 1)
          .skip(Float.BYTES)
          .put(INT8, StateQuantities.of("joint_mode"), i, 1);
    }
  }

  private static void addMasterboard(PacketLayout.Builder packet) {
    begin(packet, 75, 3)
        .put(INT32, "digital_input_bits", "digital_output_bits")
        .put(INT8, "analog_in_domain")
        .put(FLOAT64, "analog_in")
        .put(INT8, "analog_out_domain")
        .put(FLOAT64, "analog_out")
        .put(FLOAT32, "box_temperature", "robot_voltage", "robot_current", "io_current")
        .put(INT8, "safety_mode", "reduced")
        .bytes(FALSE)
        .put(INT32, "safety_checksum")
        .bytes(OPERATIONAL_MODE_INPUT, ENABLING_DEVICE_INPUT, MASTERBOARD_END);
  }

  private static void addTool(PacketLayout.Builder packet) {
    begin(packet, 37, 2)
        .put(INT8, "tool_analog_in_domain")
        .put(FLOAT64, "tool_analog_in")
        .put(FLOAT32, "robot_voltage")
        .put(INT8, "tool_voltage")
        .put(FLOAT32, "tool_current", "tool_temperature")
        .put(INT8, "tool_mode");
  }

  private static void addSerialLine(PacketLayout.Builder packet) {
    begin(packet, 26, 11)
        .put(INT8, state -> line(state).enabled() ? TRUE : FALSE)
        .put(INT32, state -> line(state).baudRate())
        .put(INT32, state -> line(state).parity().number())
        .put(INT32, state -> line(state).stopBits())
        .put(FLOAT32, state -> line(state).rxIdleChars())
        .put(FLOAT32, state -> line(state).txIdleChars());
  }

  private static ToolCommunication line(ControllerState state) {
    return state.signals().tool().communication();
  }
}
