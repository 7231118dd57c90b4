package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.io.AnalogLevels;
import org.pendant.controller.io.AnalogSignal;
import org.pendant.controller.io.ToolCommunication;
import org.pendant.controller.io.ToolConnector;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;
import org.pendant.controller.state.SupplyReadings;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.Singularity;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.script.vm.ProgramState;

/**
 * The robot state as bytes, big-endian: {@code i32 size, u8 16}, then parts of {@code u32 size, u8
 * type} and a body each.
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

  private final DhLengths dh;
  private final byte[] kinematics;
  private final byte[] configuration;

  RobotStateCodec(ArmDescription arm) {
    dh = arm.dh();
    kinematics = ConfigurationParts.kinematics(arm);
    configuration = ConfigurationParts.configuration(arm);
  }

  /** With kinematics and configuration. */
  byte[] full(ControllerState state) {
    return encode(state, true);
  }

  /** What changes all the time. */
  byte[] periodic(ControllerState state) {
    return encode(state, false);
  }

  private byte[] encode(ControllerState state, boolean full) {
    int size = full ? FULL_BYTES : PERIODIC_BYTES;
    ByteBuffer out = ByteBuffer.allocate(size).putInt(size).put(ROBOT_STATE);
    putRobotMode(state, out);
    putJoints(state, out);
    putCartesian(state, out);
    if (full) {
      out.put(kinematics);
    }
    // calibration data, which nobody outside knows
    begin(out, 53, 9).position(out.position() + 48);
    putMasterboard(state, out);
    putTool(state, out);
    if (full) {
      out.put(configuration);
    }
    putForceMode(state, out);
    begin(out, 9, 8)
        .put(FALSE)
        .put(TRUE)
        .put(bit(state.freedrive().heldBy(FreedriveHolder.INPUT)))
        .put(ADDITIONAL_END);
    putSafety(state, out);
    ToolConnector tool = state.signals().tool();
    ToolCommunication line = tool.communication();
    begin(out, 26, 11)
        .put(bit(line.enabled()))
        .putInt(line.baudRate())
        .putInt(line.parity().number())
        .putInt(line.stopBits())
        .putFloat(line.rxIdleChars())
        .putFloat(line.txIdleChars());
    begin(out, 8, 12)
        .put(bit(tool.outputMode() == ToolOutputMode.DUAL_PIN_POWER))
        .put((byte) tool.pin0().number())
        .put((byte) tool.pin1().number());
    return out.array();
  }

  private static ByteBuffer begin(ByteBuffer out, int size, int type) {
    return out.putInt(size).put((byte) type);
  }

  private static byte bit(boolean set) {
    return set ? TRUE : FALSE;
  }

  private void putRobotMode(ControllerState state, ByteBuffer out) {
    begin(out, 47, 0)
        .putLong(EventMessages.timeUs(state))
        .put(TRUE)
        .put(TRUE)
        .put(bit(RobotBits.powerOn(state)))
        .put(bit(RobotBits.emergencyStopped(state)))
        .put(bit(RobotBits.protectiveStopped(state)))
        .put(bit(RobotBits.programRunning(state)))
        .put(bit(state.program().state() == ProgramState.PAUSED))
        .put((byte) state.safety().robotMode().code())
        .put((byte) state.arm().controlMode().code())
        .putDouble(state.arm().speedFraction())
        .putDouble(state.arm().speedScaling())
        .putDouble(SPEED_LIMIT)
        .put(FALSE);
  }

  private void putJoints(ControllerState state, ByteBuffer out) {
    begin(out, 251, 1);
    for (int i = 0; i < Joints.COUNT; i++) {
      out.putDouble(state.arm().actualPositionRad().get(i))
          .putDouble(state.arm().targetPositionRad().get(i))
          .putDouble(state.arm().actualSpeedRadPerS().get(i))
          .putFloat((float) state.readings().currentA().get(i))
          .putFloat((float) SupplyReadings.jointV(state, i))
          .putFloat((float) state.readings().temperatureC().get(i))
          .putFloat(0)
          .put((byte) RobotBits.jointMode(state, i).code());
    }
  }

  private void putCartesian(ControllerState state, ByteBuffer out) {
    begin(out, 101, 4);
    Pose tcp = state.geometry().actualTcpInBase();
    Pose offset = state.arm().tool().inFlange();
    for (int i = 0; i < Pose.SIZE; i++) {
      out.putDouble(tcp.get(i));
    }
    for (int i = 0; i < Pose.SIZE; i++) {
      out.putDouble(offset.get(i));
    }
  }

  private void putMasterboard(ControllerState state, ByteBuffer out) {
    AnalogLevels analog = state.signals().analog();
    begin(out, 75, 3)
        .putInt(RobotBits.digitalInputs(state.io()))
        .putInt(RobotBits.digitalOutputs(state.io()));
    putAnalog(analog.standardIn0(), analog.standardIn1(), out);
    putAnalog(analog.standardOut0(), analog.standardOut1(), out);
    out.putFloat((float) state.readings().controllerTemperatureC())
        .putFloat((float) SupplyReadings.robotV(state))
        .putFloat((float) state.readings().robotCurrentA())
        .putFloat((float) SupplyReadings.ioCurrentA(state))
        .put((byte) RobotBits.coarse(state.safety().safetyMode()).code())
        .put(bit(state.safety().reduced()))
        .put(FALSE)
        .putInt(state.safety().checksum().value())
        .put(OPERATIONAL_MODE_INPUT)
        .put(ENABLING_DEVICE_INPUT)
        .put(MASTERBOARD_END);
  }

  private static void putAnalog(AnalogSignal first, AnalogSignal second, ByteBuffer out) {
    out.put((byte) first.domain().number())
        .put((byte) second.domain().number())
        .putDouble(first.value())
        .putDouble(second.value());
  }

  private void putTool(ControllerState state, ByteBuffer out) {
    AnalogLevels analog = state.signals().analog();
    begin(out, 37, 2);
    putAnalog(analog.toolIn0(), analog.toolIn1(), out);
    out.putFloat((float) SupplyReadings.robotV(state))
        .put((byte) state.signals().tool().voltageV())
        .putFloat((float) state.readings().toolCurrentA())
        .putFloat((float) state.readings().toolTemperatureC())
        .put((byte) RobotBits.toolMode(state).code());
  }

  /** Force at the TCP, and how far the arm is from a singularity. */
  private void putForceMode(ControllerState state, ByteBuffer out) {
    Wrench force = state.readings().flangeWrenchInBase();
    begin(out, 61, 7)
        .putDouble(force.fx())
        .putDouble(force.fy())
        .putDouble(force.fz())
        .putDouble(force.mx())
        .putDouble(force.my())
        .putDouble(force.mz())
        .putDouble(dexterity(state.arm().actualPositionRad()));
  }

  /** 0 in a singularity; goes with the determinant of the Jacobian. */
  private double dexterity(Joints q) {
    double product = 1;
    for (Singularity each : Singularity.values()) {
      product *= each.measure(dh, q);
    }
    return product;
  }

  private void putSafety(ControllerState state, ByteBuffer out) {
    Vector3 elbowM = state.geometry().actual().elbowM();
    begin(out, 43, 10)
        .putInt(state.safety().checksum().value())
        .put(TRUE)
        .put(TRUE)
        .putDouble(elbowM.x())
        .putDouble(elbowM.y())
        .putDouble(elbowM.z())
        .putDouble(SAFETY_END);
  }
}
