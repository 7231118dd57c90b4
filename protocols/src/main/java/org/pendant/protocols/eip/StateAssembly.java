package org.pendant.protocols.eip;

import static java.util.concurrent.TimeUnit.MILLISECONDS;
import static org.pendant.protocols.packet.WireType.FLOAT32;
import static org.pendant.protocols.packet.WireType.INT16;
import static org.pendant.protocols.packet.WireType.INT32;
import static org.pendant.protocols.packet.WireType.INT8;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.concurrent.locks.ReentrantLock;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SoftwareVersion;
import org.pendant.protocols.packet.PacketLayout;

/**
 * State assembly: the built-in one from robot to scanner, instance 100: what a snapshot says. Any
 * thread.
 */
final class StateAssembly {
  /** Its size. */
  static final int BYTES = 480;

  private static final int SIGNALS_AT = 32;
  private static final int JOINTS_AT = 100;
  private static final int TCP_AT = 204;
  private static final int REGISTERS_AT = 280;

  /** Registers of each kind; a fieldbus has the lower half. */
  private static final int REGISTERS = 24;

  private final PacketLayout layout;
  private final ReentrantLock lock = new ReentrantLock();

  StateAssembly() {
    PacketLayout.Builder packet = new PacketLayout.Builder(BYTES, ByteOrder.LITTLE_ENDIAN);
    addRobot(packet);
    addSignals(packet.at(SIGNALS_AT));
    packet
        .at(JOINTS_AT)
        .put(FLOAT32, "actual_q", "actual_qd", "current", "temperature")
        .put(INT8, "joint_mode");
    packet.at(TCP_AT).put(FLOAT32, "actual_tcp", "tcp_velocity", "tcp_wrench", "tcp_force");
    packet
        .at(REGISTERS_AT)
        .put(INT32, "output_register_bits")
        .put(INT32, StateQuantities.of("output_integer_register"), 0, REGISTERS)
        .put(FLOAT32, StateQuantities.of("output_float_register"), 0, REGISTERS);
    layout = packet.build();
  }

  private static void addRobot(PacketLayout.Builder packet) {
    packet
        .bytes((byte) SoftwareVersion.REPORTED.major(), (byte) SoftwareVersion.REPORTED.minor())
        .skip(2)
        .put(INT8, "robot_mode")
        .put(INT8, state -> MILLISECONDS.toSeconds(ms(state)) % 60)
        .put(INT16, state -> ms(state) % 1000)
        .put(INT8, state -> MILLISECONDS.toMinutes(ms(state)) % 60)
        .put(INT8, state -> MILLISECONDS.toHours(ms(state)) % 24)
        .put(INT16, state -> MILLISECONDS.toDays(ms(state)))
        .put(FLOAT32, "robot_current")
        .put(INT32, "robot_status_bits")
        .put(FLOAT32, "speed_slider")
        .put(INT8, "safety_mode")
        .skip(3)
        .put(INT16, "safety_status_bits");
  }

  private static long ms(ControllerState state) {
    return Math.round(1000 * state.timeS());
  }

  private static void addSignals(PacketLayout.Builder packet) {
    packet
        .put(INT8, "digital_in_bits", "configurable_in_bits")
        .put(INT8, "digital_out_bits", "configurable_out_bits", "analog_domain_bits")
        .skip(3)
        .put(FLOAT32, "analog_in", "analog_out", "io_current")
        .put(INT32, "euromap67_inputs", "euromap67_outputs")
        .put(FLOAT32, "euromap67_voltage", "euromap67_current")
        .put(INT8, "tool_mode")
        .skip(3)
        .put(INT8, "tool_in_bits", "tool_out_bits", "tool_analog_domain_bits")
        .skip(1)
        .put(FLOAT32, "tool_analog_in")
        .put(INT8, "tool_voltage")
        .skip(3)
        .put(FLOAT32, "tool_current");
  }

  /** The bytes, to be read. */
  ByteBuffer of(ControllerState state) {
    lock.lock();
    try {
      return ByteBuffer.wrap(layout.encode(state)).order(ByteOrder.LITTLE_ENDIAN);
    } finally {
      lock.unlock();
    }
  }
}
