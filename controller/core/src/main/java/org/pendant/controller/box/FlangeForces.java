package org.pendant.controller.box;

import org.pendant.controller.arm.ExternalForceSensor;
import org.pendant.controller.arm.ForceSensor;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.models.pose.Wrench;
import org.pendant.models.pose.WrenchNumbers;

/** Sensing of what pushes the tool, by the sensor in the flange or by an external one. */
final class FlangeForces {
  private final SimulatedArm arm;
  private final ArmModel model;
  private final ForceSensor ownSensor = new ForceSensor();
  private final ExternalForceSensor externalSensor = new ExternalForceSensor();
  private final WrenchNumbers wrench = new WrenchNumbers();

  /** Whether {@link #wrench} is of the arm as it stands now. */
  private boolean wrenchKnown;

  /**
   * Sensors that nothing has pushed yet.
   *
   * @param arm on whose flange they are
   * @param model knows the payload whose weight is no push
   */
  FlangeForces(SimulatedArm arm, ArmModel model) {
    this.arm = arm;
    this.model = model;
  }

  /** The arm, its load or its payload is another one: what was felt no longer holds. */
  void forget() {
    wrenchKnown = false;
  }

  /** Makes what the sensor in the flange feels now its zero (manual 18.72). */
  void zero() {
    ownSensor.zero(arm, model.payload());
    forget();
  }

  /**
   * The external wrench at the flange, along the axes of the base (manual 16.32); changes with the
   * next frame.
   */
  WrenchNumbers wrenchInBase() {
    if (!wrenchKnown) {
      ownSensor.readAtFlangeInBase(arm, model.payload(), wrench);
      wrenchKnown = true;
    }
    return wrench;
  }

  /**
   * What the sensor in the flange feels, with weights and without its zero, at the flange along its
   * axes; changes with the next frame.
   */
  WrenchNumbers rawWrench() {
    return ownSensor.felt();
  }

  /**
   * What force control has to go by, as {@link #wrenchInBase}: what an external sensor feels, while
   * there is one.
   */
  Wrench controlledWrenchInBase() {
    return externalSensor.enabled() ? externalWrenchInBase() : wrenchInBase().wrench();
  }

  /** What an external sensor feels, at the flange along the axes of the base; 0 without one. */
  Wrench externalWrenchInBase() {
    return externalSensor.enabled()
        ? externalSensor.wrenchAtFlangeInBase(arm, model.payload())
        : Wrench.ZERO;
  }

  /** What an external force/torque sensor reads. */
  ExternalForceSensor externalSensor() {
    return externalSensor;
  }
}
