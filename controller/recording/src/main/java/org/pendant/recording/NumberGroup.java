package org.pendant.recording;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;

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
  SPEED(5, "speed", 2, "speed_slider motion_scaling"),
  ACCELERATION(6, "actual_qdd", 6),
  TORQUE(7, "torque", 6),
  EXTERNAL_TORQUE(8, "external_torque", 6),
  TARGET_TORQUE(9, "target_torque", 6),
  CURRENT(10, "current", 6),
  TARGET_CURRENT(11, "target_current", 6),
  TOOL_ACCELERATION(12, "tool_acceleration", 3),
  FLANGE_WRENCH(13, "flange_wrench", 6, "tcp_wrench"),
  RAW_WRENCH(14, "raw_wrench", 6),
  TOOL_CURRENT(15, "tool_current", 1),
  /** What the robot's supply gives, and what follows from positions, speeds and torques. */
  SUPPLY(
      16,
      "supply",
      12,
      "robot_current momentum deviation collision main_voltage robot_voltage joint_voltage"),
  /** How near a link is to another or to what stands around it. */
  LINKS(17, "links", 2, "link_distance object_distance"),
  /**
   * What never rests: temperatures of joints, tool and box, energies, the computer's time. By
   * itself it is kept once in a while only, or an arm at rest would fill the ring.
   */
  AMBIENT(
      18,
      "ambient",
      11,
      "temperature tool_temperature box_temperature energy_consumed energy_dissipated");

  static final int COUNT = values().length;

  /** A bit for each group. */
  static final int ALL = (1 << COUNT) - 1;

  /**
   * What the sensors of an arm that rests say differently in each frame, because of their noise.
   * While nothing else changes they are kept as seldom as {@link #AMBIENT}.
   */
  static final int NOISY =
      AMBIENT.bit()
          | ACTUAL_Q.bit()
          | ACTUAL_QD.bit()
          | TORQUE.bit()
          | EXTERNAL_TORQUE.bit()
          | CURRENT.bit()
          | TOOL_ACCELERATION.bit()
          | FLANGE_WRENCH.bit()
          | RAW_WRENCH.bit()
          | SUPPLY.bit()
          | LINKS.bit();

  private static final NumberGroup[] GROUPS = values();
  private static final int[] SIZES = Arrays.stream(GROUPS).mapToInt(each -> each.size).toArray();

  /** The quantities of each group, one after the other. */
  private static final StateQuantity[][] QUANTITIES =
      Arrays.stream(GROUPS)
          .map(
              each ->
                  Arrays.stream(each.quantities.split(" ", -1))
                      .map(StateQuantities::of)
                      .toArray(StateQuantity[]::new))
          .toArray(StateQuantity[][]::new);

  /** Numbers of all groups together. */
  static final int NUMBERS = Arrays.stream(SIZES).sum();

  private final int index;
  private final String column;
  private final int size;
  private final String quantities;

  /** A group of the quantity that is called as the column. */
  NumberGroup(int index, String column, int size) {
    this(index, column, size, column);
  }

  NumberGroup(int index, String column, int size, String quantities) {
    this.index = index;
    this.column = column;
    this.size = size;
    this.quantities = quantities;
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
    read(state, out, ALL);
  }

  /** As {@link #read(ControllerState, double[])}, those of the groups of a mask alone. */
  static void read(ControllerState state, double[] out, int mask) {
    int begin = 0;
    for (int group = 0; group < COUNT; group++) {
      if ((mask & 1 << group) != 0) {
        read(state, out, QUANTITIES[group], begin);
      }
      begin += SIZES[group];
    }
    if ((mask & AMBIENT.bit()) != 0) {
      // the quantity counts milliseconds, and going back to seconds does not give the same number
      out[NUMBERS - 1] = state.executionTimeS();
    }
  }

  private static void read(
      ControllerState state, double[] out, StateQuantity[] quantities, int begin) {
    int at = begin;
    for (StateQuantity each : quantities) {
      each.getter().read(state, out, at);
      at += each.size();
    }
  }

  /** The place of a kept number among those that {@link #read} writes. */
  static int placeOf(Column.Reading.Kept kept) {
    return sizeOfAll(kept.group().bit() - 1) + kept.index();
  }

  /** Where a component of a quantity is kept; empty if it is not. */
  static Optional<Column.Reading.Kept> keeping(StateQuantity quantity, int component) {
    for (NumberGroup group : GROUPS) {
      int at = component;
      for (String name : group.quantities.split(" ", -1)) {
        if (name.equals(quantity.name())) {
          return Optional.of(new Column.Reading.Kept(group, at));
        }
        at += StateQuantities.of(name).size();
      }
    }
    return Optional.empty();
  }

  /** A bit for each group in which the two differ. */
  static int differences(double[] some, double[] others) {
    return differences(some, others, ALL);
  }

  /** As {@link #differences(double[], double[])}, of the groups of a mask alone. */
  static int differences(double[] some, double[] others, int of) {
    int mask = 0;
    int at = 0;
    for (int group = 0; group < COUNT; group++) {
      int end = at + SIZES[group];
      if ((of & 1 << group) != 0 && !Arrays.equals(some, at, end, others, at, end)) {
        mask |= 1 << group;
      }
      at = end;
    }
    return mask;
  }
}
