package org.pendant.controller.state;

import java.util.Optional;
import org.pendant.controller.io.PortMap;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * All registers and bits that Modbus clients read of one snapshot, and programs with {@code
 * read_port_register} and {@code read_port_bit}: signals and memory as {@link PortMap} has them,
 * and from 256 on the state of the robot, which nobody can write.
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

  private PortImage() {}

  /** The register at an address; empty where there is none. */
  public static Optional<Integer> register(int address, ControllerState state) {
    return address < FIRST
        ? PortMap.register(address, state.io(), state.signals())
        : ofRobot(address, state);
  }

  /** The bit at an address; empty where there is none. */
  public static Optional<Boolean> bit(int address, ControllerState state) {
    return address < FIRST
        ? PortMap.bit(address, state.io(), state.signals())
        : flag(address, state);
  }

  private static Optional<Boolean> flag(int address, ControllerState state) {
    return switch (address) {
      case 260 -> Optional.of(RobotBits.powerOn(state));
      case 261 -> Optional.of(RobotBits.protectiveStopped(state));
      case 262 -> Optional.of(RobotBits.emergencyStopped(state));
      case 263 -> Optional.of(RobotBits.teachButtonPressed(state));
      // the power button of a pendant that there is not
      case 264 -> Optional.of(false);
      case 265 -> Optional.of(RobotBits.stoppedDueToSafety(state));
      default -> Optional.empty();
    };
  }

  private static Optional<Integer> ofRobot(int address, ControllerState state) {
    return switch (address) {
      case 256 -> word(SoftwareVersion.REPORTED.major());
      case 257 -> word(SoftwareVersion.REPORTED.minor());
      case 258 -> word(state.safety().robotMode().code());
      case 260, 261, 262, 263, 264, 265 -> flag(address, state).map(set -> set ? 1 : 0);
      case 450 -> word(MILLI * state.readings().robotCurrentA());
      case 451 -> word(MILLI * SupplyReadings.ioCurrentA(state));
      case 768 -> word(RobotBits.toolMode(state).code());
      case 769 -> word(state.readings().toolTemperatureC());
      case 770 -> word(MILLI * state.readings().toolCurrentA());
      default -> ofArm(address, state);
    };
  }

  /** The blocks of six, one number a joint or an axis. */
  private static Optional<Integer> ofArm(int address, ControllerState state) {
    int index = address % 10;
    if (index >= Joints.COUNT) {
      return Optional.empty();
    }
    ArmReadings readings = state.readings();
    double angle = state.arm().actualPositionRad().get(index);
    return switch (address - index) {
      case 270 -> word(MILLI * (angle - TURN * Math.floor(angle / TURN)));
      case 280 -> word(MILLI * state.arm().actualSpeedRadPerS().get(index));
      case 290 -> word(MILLI * readings.currentA().get(index));
      case 300 -> word(readings.temperatureC().get(index));
      case 310 -> word(RobotBits.jointMode(state, index).code());
      case 320 -> word(Math.floor(angle / TURN));
      case 400 -> pose(state.geometry().actualTcpInBase(), index);
      case 410 -> word(MILLI * state.geometry().actual().speed().get(index));
      case 420 -> pose(state.arm().tool().inFlange(), index);
      default -> Optional.empty();
    };
  }

  private static Optional<Integer> pose(Pose pose, int index) {
    return word((index < 3 ? TENTH_MM : MILLI) * pose.get(index));
  }

  private static Optional<Integer> word(double value) {
    long rounded = Math.round(value);
    return Optional.of(Math.clamp(rounded, Short.MIN_VALUE, FULL) & FULL);
  }
}
