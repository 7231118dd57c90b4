package org.pendant.controller.box;

import org.pendant.controller.freedrive.Freedrive;
import org.pendant.controller.safety.SafetySystem;
import org.pendant.controller.safety.SpeedCaps;
import org.pendant.motion.MotionControl;
import org.pendant.motion.force.ForceMode;
import org.pendant.motion.servo.Servoing;

/**
 * Control modes besides planned moves.
 *
 * @param servoing speeds, servos and torques that programs stream
 * @param freedrive guiding the arm by hand
 * @param forceMode pressing with a force
 */
public record ControlModes(Servoing servoing, Freedrive freedrive, ForceMode forceMode) {

  /** The modes of an arm; force mode displaces it last, so its other offsets must be there. */
  static ControlModes of(
      RobotArm arm, SafetySystem safety, SpeedCaps speedCaps, MotionControl motion) {
    return new ControlModes(
        new Servoing(arm.description(), motion),
        new Freedrive(
            new Freedrive.Setup(
                arm.description(),
                arm.simulated(),
                arm.model().dynamics(),
                arm.model()::payload,
                arm.forces()::externalWrenchInBase,
                safety,
                speedCaps,
                motion)),
        new ForceMode(
            new ForceMode.Setup(
                arm.description(),
                arm.simulated(),
                arm.forces()::controlledWrenchInBase,
                speedCaps,
                safety::limits,
                motion)));
  }
}
