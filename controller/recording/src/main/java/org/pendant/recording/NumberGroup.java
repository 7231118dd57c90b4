package org.pendant.recording;

import java.util.Arrays;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Wrench;

/**
 * Number group: numbers of a snapshot that tend to change together; they are kept when one of them
 * does.
 */
enum NumberGroup {
  TARGET_Q(0, "target_q", 6),
  TARGET_QD(1, "target_qd", 6),
  TARGET_QDD(2, "target_qdd", 6),
  ACTUAL_Q(3, "actual_q", 6),
  ACTUAL_QD(4, "actual_qd", 6),
  /** Slider and scaling. */
  SPEED(5, "speed", 2),
  ACCELERATION(6, "actual_qdd", 6),
  TORQUE(7, "torque", 6),
  EXTERNAL_TORQUE(8, "external_torque", 6),
  TARGET_TORQUE(9, "target_torque", 6),
  CURRENT(10, "current", 6),
  TARGET_CURRENT(11, "target_current", 6),
  TOOL_ACCELERATION(12, "tool_acceleration", 3),
  FLANGE_WRENCH(13, "flange_wrench", 6),
  RAW_WRENCH(14, "raw_wrench", 6),
  /** Current of the tool and the robot, momentum, deviation and collision. */
  LOAD(15, "load", 5),
  /**
   * What never rests: temperatures of joints, tool and box, energies, the computer's time. By
   * itself it is kept once in a while only, or an arm at rest would fill the ring.
   */
  AMBIENT(16, "ambient", 11);

  static final int COUNT = values().length;

  /** A bit for each group. */
  static final int ALL = (1 << COUNT) - 1;

  private static final NumberGroup[] GROUPS = values();
  private static final int[] SIZES = Arrays.stream(GROUPS).mapToInt(each -> each.size).toArray();

  /** Numbers of all groups together. */
  static final int NUMBERS = Arrays.stream(SIZES).sum();

  private final int index;
  private final String column;
  private final int size;

  NumberGroup(int index, String column, int size) {
    this.index = index;
    this.column = column;
    this.size = size;
  }

  /** Its place among the groups, from 0. */
  int index() {
    return index;
  }

  /** What the header of a file calls it. */
  String column() {
    return column;
  }

  /** How many numbers it has. */
  int size() {
    return size;
  }

  /** Its bit in a mask. */
  int bit() {
    return 1 << index;
  }

  /** How many numbers group {@code index} has. */
  static int sizeOf(int index) {
    return SIZES[index];
  }

  /** How many numbers the groups of a mask have together. */
  static int sizeOfAll(int mask) {
    int sum = 0;
    for (int left = mask; left != 0; left &= left - 1) {
      sum += SIZES[Integer.numberOfTrailingZeros(left)];
    }
    return sum;
  }

  /** Writes the numbers of a snapshot to {@code out}, group after group. */
  static void read(ControllerState state, double[] out) {
    ArmState arm = state.arm();
    ArmReadings readings = state.readings();
    int at = put(arm.targetPositionRad(), out, 0);
    at = put(arm.targetSpeedRadPerS(), out, at);
    at = put(arm.targetAccelerationRadPerS2(), out, at);
    at = put(arm.actualPositionRad(), out, at);
    at = put(arm.actualSpeedRadPerS(), out, at);
    out[at++] = arm.speedFraction();
    out[at++] = arm.speedScaling();
    at = put(readings.accelerationRadPerS2(), out, at);
    at = put(readings.torqueNm(), out, at);
    at = put(readings.externalTorqueNm(), out, at);
    at = put(readings.targetTorqueNm(), out, at);
    at = put(readings.currentA(), out, at);
    at = put(readings.targetCurrentA(), out, at);
    out[at++] = readings.toolAcceleration().xMPerS2();
    out[at++] = readings.toolAcceleration().yMPerS2();
    out[at++] = readings.toolAcceleration().zMPerS2();
    at = put(readings.flangeWrenchInBase(), out, at);
    at = put(readings.rawFlangeWrench(), out, at);
    out[at++] = readings.toolCurrentA();
    out[at++] = readings.robotCurrentA();
    out[at++] = readings.momentumKgMPerS();
    out[at++] = readings.deviationRatio();
    out[at++] = readings.collisionRatio();
    at = put(readings.temperatureC(), out, at);
    out[at++] = readings.toolTemperatureC();
    out[at++] = readings.controllerTemperatureC();
    out[at++] = readings.energyConsumedJ();
    out[at++] = readings.energyDissipatedJ();
    out[at] = state.executionTimeS();
  }

  private static int put(Joints joints, double[] out, int at) {
    out[at] = joints.q0();
    out[at + 1] = joints.q1();
    out[at + 2] = joints.q2();
    out[at + 3] = joints.q3();
    out[at + 4] = joints.q4();
    out[at + 5] = joints.q5();
    return at + 6;
  }

  private static int put(Wrench wrench, double[] out, int at) {
    out[at] = wrench.fx();
    out[at + 1] = wrench.fy();
    out[at + 2] = wrench.fz();
    out[at + 3] = wrench.mx();
    out[at + 4] = wrench.my();
    out[at + 5] = wrench.mz();
    return at + 6;
  }

  /** A bit for each group in which the two differ. */
  static int differences(double[] some, double[] others) {
    int mask = 0;
    int at = 0;
    for (int group = 0; group < COUNT; group++) {
      int end = at + SIZES[group];
      if (!Arrays.equals(some, at, end, others, at, end)) {
        mask |= 1 << group;
      }
      at = end;
    }
    return mask;
  }
}
