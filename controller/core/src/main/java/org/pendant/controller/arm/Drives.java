package org.pendant.controller.arm;

/**
 * Joint drives: what the motors of the six joints do; the laws that {@link JointStep} lets them
 * follow.
 */
interface Drives {

  /**
   * Writes the law of each motor for one step, and the friction it leaves, into {@code step}.
   *
   * @param remainingS time from the end of the step to the end of the frame, s
   * @param stepS length of the step, s
   * @param body the joints at the beginning of the step
   */
  void prepare(double remainingS, double stepS, ArmBody body, JointStep step);

  /** Takes note of what came out of a step: {@code body} and {@code step} are as at its end. */
  void stepped(double remainingS, double stepS, ArmBody body, JointStep step);

  /** Writes what the target of the frame needs by the controller's model. */
  void publishTarget(SimulatedSensors sensors);

  /** Whether nothing in the drives would change if the same frame came once more. */
  boolean settled();
}
