package org.pendant.controller.state;

import org.pendant.controller.arm.SupplyMeter;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.sensor.ArmSensors;
import org.pendant.models.arm.Joints;

/**
 * Supply voltages, as the control box reads them.
 *
 * @param boxV of the supply of the control box, V
 * @param robotV at the arm, V; 0 without power
 * @param jointV at each joint, V; 0 without power
 */
public record SupplyVoltages(double boxV, double robotV, Joints jointV) {
  /** The voltages of this frame. */
  static SupplyVoltages of(ControlBox box) {
    SupplyMeter meter = box.arm().supplyMeter();
    if (!RobotBits.powerOn(box.safety().robotMode())) {
      return new SupplyVoltages(meter.boxV(), 0, Joints.ZERO);
    }
    ArmSensors sensors = box.arm().simulated().sensors();
    return new SupplyVoltages(
        meter.boxV(),
        meter.robotV(),
        new Joints(
            meter.jointV(0, sensors.currentA(0)),
            meter.jointV(1, sensors.currentA(1)),
            meter.jointV(2, sensors.currentA(2)),
            meter.jointV(3, sensors.currentA(3)),
            meter.jointV(4, sensors.currentA(4)),
            meter.jointV(5, sensors.currentA(5))));
  }
}
