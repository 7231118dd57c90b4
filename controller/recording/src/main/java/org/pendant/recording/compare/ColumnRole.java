package org.pendant.recording.compare;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;

/**
 * Column role: what a column of a table holds, told by its heading. Headings are those of RTDE's
 * clients ({@code actual_q_0}), of Pendant's own tables, and of tables that are made from ROS bags
 * with {@code /joint_states}.
 */
sealed interface ColumnRole {

  /**
   * The time of the row.
   *
   * @param unitS how many seconds a unit is
   * @param rank the column with the highest counts
   */
  record Time(double unitS, int rank) implements ColumnRole {}

  /** Whole seconds of the stamp of a ROS message. */
  record StampSeconds() implements ColumnRole {}

  /** The nanoseconds that belong to them. */
  record StampNanoseconds() implements ColumnRole {}

  /** A number of a quantity. */
  record Measure(StateQuantity quantity, int component) implements ColumnRole {}

  /** Element {@code index} of an array of a joint state; the names say which joint it is. */
  record Element(JointArray array, int index) implements ColumnRole {}

  /** All of an array of a joint state, as a list in brackets. */
  record Whole(JointArray array) implements ColumnRole {}

  /** Anything else. */
  record Other() implements ColumnRole {}

  /** The arrays of a ROS joint state. */
  enum JointArray {
    NAME,
    POSITION,
    VELOCITY,
    EFFORT;

    /** What it tells of the joints: effort is the current, in the drivers of these arms. */
    Optional<StateQuantity> quantity() {
      return switch (this) {
        case NAME -> Optional.empty();
        case POSITION -> Optional.of(SampledQuantity.ACTUAL_Q);
        case VELOCITY -> Optional.of(SampledQuantity.ACTUAL_QD);
        case EFFORT -> Optional.of(SampledQuantity.CURRENT);
      };
    }
  }

  /** The joints from the base on, as ROS calls them; a prefix may stand before. */
  List<String> ROS_JOINTS =
      List.of(
          "shoulder_pan_joint",
          "shoulder_lift_joint",
          "elbow_joint",
          "wrist_1_joint",
          "wrist_2_joint",
          "wrist_3_joint");

  /** The joint that ROS calls {@code name}, 0 to 5; -1 for another, such as that of a gripper. */
  static int jointOf(String name) {
    for (int i = 0; i < ROS_JOINTS.size(); i++) {
      if (name.endsWith(ROS_JOINTS.get(i))) {
        return i;
      }
    }
    return -1;
  }

  /** What the column under {@code heading} holds. */
  static ColumnRole of(String heading) {
    Measure number = Headings.NUMBERS.get(heading);
    if (number != null) {
      return number;
    }
    ColumnRole time = Headings.TIMES.get(heading.toLowerCase(Locale.ROOT));
    return time != null ? time : Headings.rosRole(heading);
  }

  /** The headings that are known. */
  final class Headings {
    private static final double NANO = 1e-9;
    private static final Pattern JOINT_NAMED =
        Pattern.compile(".*?(\\w+_joint)[./](position|velocity|effort)");
    private static final Pattern JOINT_STATE =
        Pattern.compile("(?:.*[./])?(name|position|velocity|effort)(?:[._]?\\[?(\\d{1,2})]?)?");

    private static final Map<String, ColumnRole> TIMES =
        Map.ofEntries(
            Map.entry("time_s", new Time(1, 3)),
            Map.entry("timestamp", new Time(1, 3)),
            Map.entry("%time", new Time(NANO, 1)),
            Map.entry("__time", new Time(1, 1)),
            Map.entry("time", new Time(1, 1)),
            Map.entry("t", new Time(1, 1)),
            Map.entry("field.header.stamp", new Time(NANO, 2)),
            Map.entry(".header.stamp.secs", new StampSeconds()),
            Map.entry("header.stamp.secs", new StampSeconds()),
            Map.entry("header.stamp.sec", new StampSeconds()),
            Map.entry(".header.stamp.nsecs", new StampNanoseconds()),
            Map.entry("header.stamp.nsecs", new StampNanoseconds()),
            Map.entry("header.stamp.nanosec", new StampNanoseconds()));

    private static final Map<String, Measure> NUMBERS = numbers();

    private Headings() {}

    private static Map<String, Measure> numbers() {
      Map<String, Measure> numbers = new HashMap<>();
      for (StateQuantity each : StateQuantities.all()) {
        String name = SampledQuantity.name(each);
        for (int i = 0; i < each.size(); i++) {
          Measure number = new Measure(each, i);
          numbers.put(SampledQuantity.name(each, i), number);
          numbers.put(each.components().get(i).name(), number);
          if (each.size() > 1) {
            // that of Pendant's own tables, and of others that count from a letter's subscript
            numbers.put(each.name() + "_" + i, number);
            numbers.put(name + "[" + i + "]", number);
          }
        }
      }
      // of the same quantity in the simulation, yet another one on a real arm
      numbers.keySet().removeIf(heading -> heading.equals("timestamp"));
      return numbers;
    }

    private static ColumnRole rosRole(String heading) {
      Matcher named = JOINT_NAMED.matcher(heading);
      if (named.matches() && jointOf(named.group(1)) >= 0) {
        return JointArray.valueOf(named.group(2).toUpperCase(Locale.ROOT))
            .quantity()
            .<ColumnRole>map(quantity -> new Measure(quantity, jointOf(named.group(1))))
            .orElseGet(Other::new);
      }
      Matcher state = JOINT_STATE.matcher(heading);
      if (!state.matches()) {
        return new Other();
      }
      JointArray array = JointArray.valueOf(state.group(1).toUpperCase(Locale.ROOT));
      return state.group(2) == null
          ? new Whole(array)
          : new Element(array, Integer.parseInt(state.group(2)));
    }
  }
}
