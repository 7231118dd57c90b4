package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogLevels;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterLevels;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;
import org.pendant.controller.state.SoftwareVersion;
import org.pendant.controller.state.SupplyReadings;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** The built-in assembly from robot to scanner, instance 100: what a snapshot says. */
final class StateAssembly {
  /** Its size. */
  static final int BYTES = 480;

  private static final int ROBOT_AT = 0;
  private static final int SIGNALS_AT = 32;
  private static final int JOINTS_AT = 100;
  private static final int TCP_AT = 204;
  private static final int REGISTERS_AT = 280;

  /** Registers of each kind; a fieldbus has the lower half. */
  private static final int REGISTERS = 24;

  private StateAssembly() {}

  /** The bytes, to be read. */
  static ByteBuffer of(ControllerState state) {
    ByteBuffer out = ByteBuffer.allocate(BYTES).order(ByteOrder.LITTLE_ENDIAN);
    putRobot(state, out.position(ROBOT_AT));
    putSignals(state, out.position(SIGNALS_AT));
    putJoints(state, out.position(JOINTS_AT));
    putTcp(state, out.position(TCP_AT));
    putRegisters(state.signals().registers(RegisterDirection.OUTPUT), out.position(REGISTERS_AT));
    return out.flip();
  }

  private static void putRobot(ControllerState state, ByteBuffer out) {
    out.put((byte) SoftwareVersion.REPORTED.major());
    out.put((byte) SoftwareVersion.REPORTED.minor()).putShort((short) 0);
    out.put((byte) state.safety().robotMode().code());
    long ms = Math.round(1000 * state.timeS());
    long seconds = TimeUnit.MILLISECONDS.toSeconds(ms);
    out.put((byte) (seconds % 60)).putShort((short) (ms % 1000));
    out.put((byte) (seconds / 60 % 60)).put((byte) (seconds / 3600 % 24));
    out.putShort((short) (seconds / 86_400));
    out.putFloat((float) state.readings().robotCurrentA());
    out.putInt(RobotBits.robotStatus(state));
    out.putFloat((float) state.arm().speedFraction());
    out.put((byte) RobotBits.coarse(state.safety().safetyMode()).code()).position(28);
    out.putShort((short) RobotBits.safetyStatus(state));
  }

  private static void putSignals(ControllerState state, ByteBuffer out) {
    AnalogLevels analog = state.signals().analog();
    out.put((byte) state.io().standardIn()).put((byte) state.io().configurableIn());
    out.put((byte) state.io().standardOut()).put((byte) state.io().configurableOut());
    out.put((byte) analog.standardDomainBits()).position(SIGNALS_AT + 8);
    putPair(analog, AnalogBank.STANDARD_IN, out);
    putPair(analog, AnalogBank.STANDARD_OUT, out);
    out.putFloat((float) SupplyReadings.ioCurrentA(state));
    // there is no connector for an injection moulding machine
    out.putInt(0).putInt(0).putFloat(0).putFloat(0);
    out.put((byte) RobotBits.toolMode(state).code()).position(SIGNALS_AT + 48);
    out.put((byte) state.io().toolIn()).put((byte) state.io().toolOut());
    out.put((byte) analog.toolDomainBits()).put((byte) 0);
    putPair(analog, AnalogBank.TOOL_IN, out);
    out.put((byte) state.signals().tool().voltageV()).position(SIGNALS_AT + 64);
    out.putFloat((float) state.readings().toolCurrentA());
  }

  private static void putPair(AnalogLevels analog, AnalogBank bank, ByteBuffer out) {
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      out.putFloat((float) analog.signal(bank, i).value());
    }
  }

  private static void putJoints(ControllerState state, ByteBuffer out) {
    ArmReadings readings = state.readings();
    putJoints(state.arm().actualPositionRad(), out);
    putJoints(state.arm().actualSpeedRadPerS(), out);
    putJoints(readings.currentA(), out);
    putJoints(readings.temperatureC(), out);
    for (int i = 0; i < Joints.COUNT; i++) {
      out.put((byte) RobotBits.jointMode(state, i).code());
    }
  }

  private static void putJoints(Joints joints, ByteBuffer out) {
    for (int i = 0; i < Joints.COUNT; i++) {
      out.putFloat((float) joints.get(i));
    }
  }

  private static void putTcp(ControllerState state, ByteBuffer out) {
    putPose(state.geometry().actualTcpInBase(), out);
    putPose(state.geometry().actual().speed(), out);
    Wrench w = state.readings().flangeWrenchInBase();
    out.putFloat((float) w.fx()).putFloat((float) w.fy()).putFloat((float) w.fz());
    out.putFloat((float) w.mx()).putFloat((float) w.my()).putFloat((float) w.mz());
    out.putFloat((float) Math.sqrt(w.fx() * w.fx() + w.fy() * w.fy() + w.fz() * w.fz()));
  }

  private static void putPose(Pose pose, ByteBuffer out) {
    for (int i = 0; i < Pose.SIZE; i++) {
      out.putFloat((float) pose.get(i));
    }
  }

  private static void putRegisters(RegisterLevels registers, ByteBuffer out) {
    out.putLong(registers.lowBits());
    for (int i = 0; i < REGISTERS; i++) {
      out.putInt(registers.integer(i));
    }
    for (int i = 0; i < REGISTERS; i++) {
      out.putFloat((float) registers.floating(i));
    }
  }
}
