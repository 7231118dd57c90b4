package org.pendant.desktop.io;

import java.util.List;
import java.util.Locale;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

/** Sensor readings as texts; the rows are always the same, so that only texts change. */
final class Readings {
  /** Titles of the columns of {@link #joint}. */
  static final List<String> JOINT_COLUMNS = List.of("Position", "Current", "Torque", "Temperature");

  /** Titles of the joints from base to wrist 3. */
  static final List<String> JOINTS =
      List.of("Base", "Shoulder", "Elbow", "Wrist 1", "Wrist 2", "Wrist 3");

  /** Titles of {@link #others}. */
  static final List<String> OTHERS =
      List.of(
          "Tool temperature",
          "Controller temperature",
          "Tool current",
          "TCP force",
          "Force along base x, y, z",
          "Torque about base x, y, z",
          "Payload",
          "Centre of gravity");

  private Readings() {}

  /** What is known of one joint, 0 to 5, in the order of the columns. */
  static List<String> joint(ControllerState state, int joint) {
    ArmReadings readings = state.readings();
    Joints positionRad = state.arm().actualPositionRad();
    return List.of(
        number(1, Math.toDegrees(positionRad.get(joint))) + "\u00b0",
        number(2, readings.currentA().get(joint)) + " A",
        number(1, readings.torqueNm().get(joint)) + " Nm",
        number(1, readings.temperatureC().get(joint)) + " \u00b0C");
  }

  /** The texts beside {@link #OTHERS}. */
  static List<String> others(ControllerState state) {
    ArmReadings readings = state.readings();
    Wrench wrench = readings.flangeWrenchInBase();
    Payload payload = readings.payload();
    double forceN =
        Math.sqrt(
            wrench.fx() * wrench.fx() + wrench.fy() * wrench.fy() + wrench.fz() * wrench.fz());
    return List.of(
        number(1, readings.toolTemperatureC()) + " \u00b0C",
        number(1, readings.controllerTemperatureC()) + " \u00b0C",
        number(3, readings.toolCurrentA()) + " A",
        number(1, forceN) + " N",
        three(1, wrench.fx(), wrench.fy(), wrench.fz()) + " N",
        three(2, wrench.mx(), wrench.my(), wrench.mz()) + " Nm",
        number(2, payload.massKg()) + " kg",
        three(1, 1e3 * payload.cogXM(), 1e3 * payload.cogYM(), 1e3 * payload.cogZM()) + " mm");
  }

  private static String three(int digits, double x, double y, double z) {
    return number(digits, x) + ", " + number(digits, y) + ", " + number(digits, z);
  }

  /** Without a minus sign in front of nothing but zeros. */
  private static String number(int digits, double value) {
    double scale = Math.pow(10, digits);
    double rounded = Math.round(value * scale) / scale;
    return String.format(Locale.ROOT, "%." + digits + "f", rounded == 0 ? 0.0 : rounded);
  }
}
