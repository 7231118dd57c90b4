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
    list.group("load");
    addMasses(list);
    addBase(list);
    list.group("power");
    addPower(list);
  }

  private static void addMasses(QuantityList list) {
    list.number("payload", "payload", KILOGRAM, s -> s.readings().payload().massKg())
        .rtde("payload");
    list.axes(
            "payload_cog",
            "centreOfGravity",
            "x y z",
            METRE,
            List.of(
                s -> s.readings().payload().cogXM(),
                s -> s.readings().payload().cogYM(),
                s -> s.readings().payload().cogZM()))
        .explained("cogExplained")
        .rtde("payload_cog");
    list.axes(
            "payload_inertia",
            "inertia",
            "xx yy zz xy xz yz",
            KILOGRAM_METRE_SQUARED,
            List.of(
                s -> s.readings().payload().ixx(),
                s -> s.readings().payload().iyy(),
                s -> s.readings().payload().izz(),
                s -> s.readings().payload().ixy(),
                s -> s.readings().payload().ixz(),
                s -> s.readings().payload().iyz()))
        .explained("inertiaExplained")
        .rtde("payload_inertia");
    list.number(
            "momentum", "momentum", KILOGRAM_METRE_PER_SECOND, s -> s.readings().momentumKgMPerS())
        .rtde("actual_momentum");
  }

  private static void addBase(QuantityList list) {
    list.axes(
            "gravity",
            "gravity",
            "x y z",
            METRE_PER_SECOND_SQUARED,
            List.of(
                s -> s.readings().mounting().gravityXMPerS2(),
                s -> s.readings().mounting().gravityYMPerS2(),
                s -> s.readings().mounting().gravityZMPerS2()))
        .explained("gravityExplained")
        .rtde("target_gravity");
    // the base does not turn
    list.axes(
            "base_acceleration",
            "baseAcceleration",
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
    list.number("main_voltage", "mainVoltage", VOLT, s -> s.readings().voltages().boxV())
        .rtde("actual_main_voltage");
    list.number("robot_voltage", "robotVoltage", VOLT, s -> s.readings().voltages().robotV())
        .rtde("actual_robot_voltage");
    list.number("robot_current", "robotCurrent", AMPERE, s -> s.readings().robotCurrentA())
        .rtde("actual_robot_current");
    list.number("io_current", "ioCurrent", AMPERE, SupplyReadings::ioCurrentA)
        .explained("ioCurrentExplained")
        .rtde("io_current");
    list.number("tool_current", "toolCurrent", AMPERE, s -> s.readings().toolCurrentA())
        .rtde("tool_output_current");
    list.number("energy_consumed", "energyConsumed", JOULE, s -> s.readings().energyConsumedJ())
        .explained("energyExplained")
        .rtde("actual_robot_energy_consumed");
    list.number(
            "energy_dissipated",
            "brakingEnergyDissipated",
            JOULE,
            s -> s.readings().energyDissipatedJ())
        .explained("energyExplained")
        .rtde("actual_robot_braking_energy_dissipated");
    list.number(
            "tool_temperature", "toolTemperature", CELSIUS, s -> s.readings().toolTemperatureC())
        .rtde("tool_temperature");
    list.number(
        "box_temperature", "boxTemperature", CELSIUS, s -> s.readings().controllerTemperatureC());
  }
}
