package org.pendant.controller.quantity;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.io.PortMap;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SoftwareVersion;

/**
 * Port image: all registers and bits that Modbus clients read of one snapshot, and programs with
 * {@code read_port_register} and {@code read_port_bit}: signals and memory as {@link PortMap} has
 * them, and from 256 on the state of the robot, which no client can write.
 *
 * <p>Registers are 16 bits, 0 to 65535; negative numbers are their two's complement, and what is
 * beyond 16 bits stands at the end of the range.
 */
public final class PortImage {
  /** The lowest address of the robot's state. */
  public static final int FIRST = 256;

  private static final int FULL = 0xFFFF;
  private static final double MILLI = 1e3;
  private static final double TENTH_MM = 1e4;
  private static final double TURN = 2 * Math.PI;

  /** Addresses of flags, which are registers and bits alike. */
  private static final int FIRST_FLAG = 260;

  private static final int LAST_FLAG = 265;

  private static final Map<Integer, ToDoubleFunction<ControllerState>> OF_ROBOT = ofRobot();

  private PortImage() {}

  /** The register at an address; empty where there is none. */
  public static Optional<Integer> register(int address, ControllerState state) {
    return address < FIRST
        ? PortMap.register(address, state.io(), state.signals())
        : Optional.ofNullable(OF_ROBOT.get(address)).map(value -> word(value, state));
  }

  private static int word(ToDoubleFunction<ControllerState> value, ControllerState state) {
    return Math.clamp(Math.round(value.applyAsDouble(state)), Short.MIN_VALUE, FULL) & FULL;
  }

  /** The bit at an address; empty where there is none. */
  public static Optional<Boolean> bit(int address, ControllerState state) {
    if (address < FIRST) {
      return PortMap.bit(address, state.io(), state.signals());
    }
    return address >= FIRST_FLAG && address <= LAST_FLAG
        ? register(address, state).map(word -> word != 0)
        : Optional.empty();
  }

  private static Map<Integer, ToDoubleFunction<ControllerState>> ofRobot() {
    Map<Integer, ToDoubleFunction<ControllerState>> image = new HashMap<>();
    image.put(256, state -> SoftwareVersion.REPORTED.major());
    image.put(257, state -> SoftwareVersion.REPORTED.minor());
    put(image, 258, 1, "robot_mode");
    put(image, 260, 1, "power_on");
    put(image, 261, 1, "protective_stopped");
    put(image, 262, 1, "emergency_stopped");
    put(image, 263, 1, "teach_button");
    // the power button of a pendant that there is not
    image.put(264, state -> 0);
    put(image, 265, 1, "safety_stopped");
    for (int joint = 0; joint < StateQuantities.of("actual_q").size(); joint++) {
      ToDoubleFunction<ControllerState> angle =
          StateQuantities.of("actual_q").getter().element(joint);
      image.put(
          270 + joint,
          state -> {
            double rad = angle.applyAsDouble(state);
            return MILLI * (rad - TURN * Math.floor(rad / TURN));
          });
      image.put(320 + joint, state -> Math.floor(angle.applyAsDouble(state) / TURN));
    }
    put(image, 280, MILLI, "actual_qd");
    put(image, 290, MILLI, "current");
    put(image, 300, 1, "temperature");
    put(image, 310, 1, "joint_mode");
    putPose(image, 400, "actual_tcp");
    put(image, 410, MILLI, "tcp_velocity");
    putPose(image, 420, "tcp_offset");
    put(image, 450, MILLI, "robot_current");
    put(image, 451, MILLI, "io_current");
    put(image, 768, 1, "tool_mode");
    put(image, 769, 1, "tool_temperature");
    put(image, 770, MILLI, "tool_current");
    return image;
  }

  /** The components of a quantity in registers that follow each other. */
  private static void put(
      Map<Integer, ToDoubleFunction<ControllerState>> image,
      int address,
      double scale,
      String quantity) {
    StateQuantity found = StateQuantities.of(quantity);
    for (int i = 0; i < found.size(); i++) {
      put(image, address + i, scale, found.getter().element(i));
    }
  }

  private static void putPose(
      Map<Integer, ToDoubleFunction<ControllerState>> image, int address, String pose) {
    Getter getter = StateQuantities.of(pose).getter();
    for (int i = 0; i < 6; i++) {
      put(image, address + i, i < 3 ? TENTH_MM : MILLI, getter.element(i));
    }
  }

  private static void put(
      Map<Integer, ToDoubleFunction<ControllerState>> image,
      int address,
      double scale,
      ToDoubleFunction<ControllerState> value) {
    image.put(address, state -> scale * value.applyAsDouble(state));
  }
}
