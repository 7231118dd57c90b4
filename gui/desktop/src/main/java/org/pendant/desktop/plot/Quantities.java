package org.pendant.desktop.plot;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** What can be drawn, in the order of the list; script variables come first. */
public final class Quantities {
  private static final List<String> JOINTS =
      List.of("Base", "Shoulder", "Elbow", "Wrist 1", "Wrist 2", "Wrist 3");
  private static final List<String> AXES = List.of("x", "y", "z", "rx", "ry", "rz");

  private final Map<String, Quantity> byId = new LinkedHashMap<>();
  private final ScriptVariables variables = new ScriptVariables();

  /** What every controller has. */
  public static Quantities standard() {
    return standard(signal -> "");
  }

  /**
   * What every controller has.
   *
   * @param names what people call a signal, by an id such as {@code digital-in-0}; empty text for
   *     none
   */
  public static Quantities standard(Function<String, String> names) {
    Quantities all = new Quantities();
    all.addJoints();
    all.addTool();
    all.addController();
    new SignalQuantities(names, all::add).addAll();
    return all;
  }

  /**
   * Adds one.
   *
   * @throws IllegalArgumentException if there is one of this id already
   */
  public void add(Quantity quantity) {
    if (byId.putIfAbsent(quantity.id(), quantity) != null) {
      throw new IllegalArgumentException("quantity " + quantity.id() + " is there already");
    }
  }

  /** All of them. */
  public List<Quantity> all() {
    return Stream.concat(variables.all().stream(), byId.values().stream()).toList();
  }

  /** The one called {@code id}; script variables are found also while no program has them. */
  public Optional<Quantity> find(String id) {
    Quantity present = byId.get(id);
    return present == null ? variables.find(id) : Optional.of(present);
  }

  ScriptVariables variables() {
    return variables;
  }

  /** Those whose group and title have every word of {@code text}, upper and lower case alike. */
  public List<Quantity> search(String text) {
    String[] words = text.strip().toLowerCase(Locale.ROOT).split("\\s+");
    return all().stream().filter(each -> hasAll(each, words)).toList();
  }

  private static boolean hasAll(Quantity quantity, String[] words) {
    String text =
        (quantity.group() + " " + quantity.namedTitle() + " " + quantity.id())
            .toLowerCase(Locale.ROOT);
    for (String word : words) {
      if (!text.contains(word)) {
        return false;
      }
    }
    return true;
  }

  private void addJoints() {
    joints("target_q", "Target position", "\u00b0", true, s -> s.arm().targetPositionRad());
    joints("actual_q", "Actual position", "\u00b0", true, s -> s.arm().actualPositionRad());
    joints("target_qd", "Target speed", "\u00b0/s", true, s -> s.arm().targetSpeedRadPerS());
    joints("actual_qd", "Actual speed", "\u00b0/s", true, s -> s.arm().actualSpeedRadPerS());
    joints("torque", "Torque", "Nm", false, s -> s.readings().torqueNm());
    joints("target_torque", "Target torque", "Nm", false, s -> s.readings().targetTorqueNm());
    joints("external_torque", "External torque", "Nm", false, s -> s.readings().externalTorqueNm());
    joints("current", "Current", "A", false, s -> s.readings().currentA());
    joints("target_current", "Target current", "A", false, s -> s.readings().targetCurrentA());
    joints("temperature", "Temperature", "\u00b0C", false, s -> s.readings().temperatureC());
  }

  private void joints(
      String id,
      String title,
      String unit,
      boolean degrees,
      Function<ControllerState, Joints> values) {
    for (int i = 0; i < Joints.COUNT; i++) {
      int joint = i;
      double scale = degrees ? Math.toDegrees(1) : 1;
      add(
          new Quantity(
              id + "_" + i,
              "Joints/" + title,
              JOINTS.get(i),
              title + ", " + JOINTS.get(i).toLowerCase(Locale.ROOT),
              unit,
              state -> scale * values.apply(state).get(joint)));
    }
  }

  private void addTool() {
    pose("target_tcp", "Target pose", s -> s.arm().targetTcpInBase());
    pose("actual_tcp", "Actual pose", s -> s.arm().actualTcpInBase());
    String speed = "TCP/Speed";
    tool("tcp_speed", speed, "length", "mm/s", s -> 1e3 * TcpSpeed.of(s.arm()).mPerS());
    tool("tcp_speed_x", speed, "x", "mm/s", s -> 1e3 * TcpSpeed.of(s.arm()).xMPerS());
    tool("tcp_speed_y", speed, "y", "mm/s", s -> 1e3 * TcpSpeed.of(s.arm()).yMPerS());
    tool("tcp_speed_z", speed, "z", "mm/s", s -> 1e3 * TcpSpeed.of(s.arm()).zMPerS());
    String force = "TCP/Force";
    tool("tcp_force", force, "length", "N", s -> lengthN(s.readings().flangeWrenchInBase()));
    tool("tcp_force_x", force, "x", "N", s -> s.readings().flangeWrenchInBase().fx());
    tool("tcp_force_y", force, "y", "N", s -> s.readings().flangeWrenchInBase().fy());
    tool("tcp_force_z", force, "z", "N", s -> s.readings().flangeWrenchInBase().fz());
    tool("tcp_torque_x", force, "Torque x", "Nm", s -> s.readings().flangeWrenchInBase().mx());
    tool("tcp_torque_y", force, "Torque y", "Nm", s -> s.readings().flangeWrenchInBase().my());
    tool("tcp_torque_z", force, "Torque z", "Nm", s -> s.readings().flangeWrenchInBase().mz());
  }

  private void pose(String id, String title, Function<ControllerState, Pose> values) {
    for (int i = 0; i < Pose.SIZE; i++) {
      int axis = i;
      boolean place = i < 3;
      double scale = place ? 1e3 : Math.toDegrees(1);
      tool(
          id + "_" + AXES.get(i),
          "TCP/" + title,
          AXES.get(i),
          place ? "mm" : "\u00b0",
          state -> scale * values.apply(state).get(axis));
    }
  }

  private void tool(
      String id, String group, String title, String unit, ToDoubleFunction<ControllerState> value) {
    add(new Quantity(id, group, title, label(group, title), unit, value));
  }

  /** Titles of signals and of the controller say enough alone. */
  private static String label(String group, String title) {
    int slash = group.indexOf('/');
    return group.startsWith("TCP/")
        ? "TCP " + group.substring(slash + 1).toLowerCase(Locale.ROOT) + ", " + title
        : title;
  }

  private static double lengthN(Wrench wrench) {
    return Math.sqrt(
        wrench.fx() * wrench.fx() + wrench.fy() * wrench.fy() + wrench.fz() * wrench.fz());
  }

  private void addController() {
    String group = "Controller";
    tool("speed_scaling", group, "Speed scaling", "%", s -> 100 * s.arm().speedScaling());
    tool("speed_slider", group, "Speed slider", "%", s -> 100 * s.arm().speedFraction());
    tool("program_line", group, "Program line", "", s -> s.program().line());
    tool("tool_current", group, "Tool current", "A", s -> s.readings().toolCurrentA());
    tool("tool_temperature", group, "Tool temperature", "\u00b0C", Quantities::toolC);
    tool("box_temperature", group, "Box temperature", "\u00b0C", Quantities::boxC);
    tool("payload", group, "Payload", "kg", s -> s.readings().payload().massKg());
  }

  private static double toolC(ControllerState state) {
    return state.readings().toolTemperatureC();
  }

  private static double boxC(ControllerState state) {
    return state.readings().controllerTemperatureC();
  }
}
