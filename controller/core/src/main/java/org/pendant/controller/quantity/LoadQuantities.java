package org.pendant.controller.quantity;

import static org.pendant.controller.quantity.PhysicalUnit.AMPERE;
import static org.pendant.controller.quantity.PhysicalUnit.CELSIUS;
import static org.pendant.controller.quantity.PhysicalUnit.JOULE;
import static org.pendant.controller.quantity.PhysicalUnit.KILOGRAM;
import static org.pendant.controller.quantity.PhysicalUnit.KILOGRAM_METRE_PER_SECOND;
import static org.pendant.controller.quantity.PhysicalUnit.KILOGRAM_METRE_SQUARED;
import static org.pendant.controller.quantity.PhysicalUnit.METRE;
import static org.pendant.controller.quantity.PhysicalUnit.METRE_PER_SECOND_SQUARED;
import static org.pendant.controller.quantity.PhysicalUnit.VOLT;

import java.util.List;
import org.pendant.controller.state.SupplyReadings;

/** Quantities of masses, of the base, and of what supplies the arm. */
final class LoadQuantities {
  private LoadQuantities() {}

  static void declareIn(QuantityList list) {
    list.group("Load");
    addMasses(list);
    addBase(list);
    list.group("Power");
    addPower(list);
  }

  private static void addMasses(QuantityList list) {
    list.number("payload", "Payload", KILOGRAM, s -> s.readings().payload().massKg())
        .rtde("payload");
    list.axes(
            "payload_cog",
            "Centre of gravity",
            "x y z",
            METRE,
            List.of(
                s -> s.readings().payload().cogXM(),
                s -> s.readings().payload().cogYM(),
                s -> s.readings().payload().cogZM()))
        .explained("In the frame of the flange")
        .rtde("payload_cog");
    list.axes(
            "payload_inertia",
            "Inertia",
            "xx yy zz xy xz yz",
            KILOGRAM_METRE_SQUARED,
            List.of(
                s -> s.readings().payload().ixx(),
                s -> s.readings().payload().iyy(),
                s -> s.readings().payload().izz(),
                s -> s.readings().payload().ixy(),
                s -> s.readings().payload().ixz(),
                s -> s.readings().payload().iyz()))
        .explained("About the centre of gravity, along the flange's axes")
        .rtde("payload_inertia");
    list.number(
            "momentum", "Momentum", KILOGRAM_METRE_PER_SECOND, s -> s.readings().momentumKgMPerS())
        .rtde("actual_momentum");
  }

  private static void addBase(QuantityList list) {
    list.axes(
            "gravity",
            "Gravity",
            "x y z",
            METRE_PER_SECOND_SQUARED,
            List.of(
                s -> s.readings().mounting().gravityXMPerS2(),
                s -> s.readings().mounting().gravityYMPerS2(),
                s -> s.readings().mounting().gravityZMPerS2()))
        .explained("What the resting arm feels")
        .rtde("target_gravity");
    // the base does not turn
    list.axes(
            "base_acceleration",
            "Base acceleration",
            "x y z rx ry rz",
            METRE_PER_SECOND_SQUARED,
            List.of(
                s -> s.readings().mounting().accelerationXMPerS2(),
                s -> s.readings().mounting().accelerationYMPerS2(),
                s -> s.readings().mounting().accelerationZMPerS2(),
                s -> 0,
                s -> 0,
                s -> 0))
        .rtde("target_base_acceleration");
  }

  private static void addPower(QuantityList list) {
    list.number("main_voltage", "Main voltage", VOLT, s -> s.readings().voltages().boxV())
        .rtde("actual_main_voltage");
    list.number("robot_voltage", "Robot voltage", VOLT, s -> s.readings().voltages().robotV())
        .rtde("actual_robot_voltage");
    list.number("robot_current", "Robot current", AMPERE, s -> s.readings().robotCurrentA())
        .rtde("actual_robot_current");
    list.number("io_current", "I/O current", AMPERE, SupplyReadings::ioCurrentA)
        .explained("What the outputs of the control box drive")
        .rtde("io_current");
    list.number("tool_current", "Tool current", AMPERE, s -> s.readings().toolCurrentA())
        .rtde("tool_output_current");
    list.number("energy_consumed", "Energy consumed", JOULE, s -> s.readings().energyConsumedJ())
        .explained("Since the controller was switched on")
        .rtde("actual_robot_energy_consumed");
    list.number(
            "energy_dissipated",
            "Braking energy dissipated",
            JOULE,
            s -> s.readings().energyDissipatedJ())
        .explained("Since the controller was switched on")
        .rtde("actual_robot_braking_energy_dissipated");
    list.number(
            "tool_temperature", "Tool temperature", CELSIUS, s -> s.readings().toolTemperatureC())
        .rtde("tool_temperature");
    list.number(
        "box_temperature", "Box temperature", CELSIUS, s -> s.readings().controllerTemperatureC());
  }
}
