package org.pendant.models.arm;

import java.util.List;

/**
 * Arm description: everything the program knows about one arm model.
 *
 * @param id the word that selects it, such as {@code ur5e}
 * @param displayName the name for people
 * @param series its generation
 * @param dh lengths of the kinematic chain of the model
 * @param calibration how one arm of the model differs from that
 * @param joints limits of the six joints, base first
 * @param actuators drives of the six joints
 * @param links masses of the six moving links, shoulder first
 * @param payloadKg rated payload, kg
 * @param reachM rated reach, m
 * @param status how far the numbers can be trusted
 * @param notes where a number that is not verified comes from
 */
public record ArmDescription(
    String id,
    String displayName,
    Series series,
    DhLengths dh,
    Calibration calibration,
    List<JointLimits> joints,
    List<Actuator> actuators,
    List<LinkMass> links,
    double payloadKg,
    double reachM,
    Status status,
    List<String> notes) {
  /**
   * Trust in each group of numbers; that in the drives differs from joint to joint and is with
   * {@link Actuator#status}.
   *
   * @param kinematics of the lengths
   * @param masses of masses and centres of mass
   * @param inertias of the links
   * @param jointLimits of ranges, speeds and torques
   */
  public record Status(
      Confidence kinematics, Confidence masses, Confidence inertias, Confidence jointLimits) {}

  /**
   * Checks the counts and copies the lists.
   *
   * @throws IllegalArgumentException if there are not six joints, actuators and links
   */
  public ArmDescription {
    joints = List.copyOf(joints);
    actuators = List.copyOf(actuators);
    links = List.copyOf(links);
    notes = List.copyOf(notes);
    if (joints.size() != Joints.COUNT
        || actuators.size() != Joints.COUNT
        || links.size() != Joints.COUNT) {
      throw new IllegalArgumentException(
          id
              + ": has "
              + joints.size()
              + " joints, "
              + actuators.size()
              + " actuators and "
              + links.size()
              + " links, must have "
              + Joints.COUNT
              + " of each");
    }
  }

  /** The same arm with other joint limits. */
  public ArmDescription withJoints(List<JointLimits> limits) {
    return new ArmDescription(
        id,
        displayName,
        series,
        dh,
        calibration,
        limits,
        actuators,
        links,
        payloadKg,
        reachM,
        status,
        notes);
  }

  /** The same arm with other drives. */
  public ArmDescription withActuators(List<Actuator> drives) {
    return new ArmDescription(
        id,
        displayName,
        series,
        dh,
        calibration,
        joints,
        drives,
        links,
        payloadKg,
        reachM,
        status,
        notes);
  }

  /** One arm of this model, as its calibration tells. */
  public ArmDescription withCalibration(Calibration ofArm) {
    return new ArmDescription(
        id,
        displayName,
        series,
        dh,
        ofArm,
        joints,
        actuators,
        links,
        payloadKg,
        reachM,
        status,
        notes);
  }

  /** The same arm with other notes. */
  public ArmDescription withNotes(List<String> others) {
    return new ArmDescription(
        id,
        displayName,
        series,
        dh,
        calibration,
        joints,
        actuators,
        links,
        payloadKg,
        reachM,
        status,
        others);
  }

  /** True if every joint position (rad) lies within its range. */
  public boolean withinLimits(Joints q) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!joints.get(i).contains(q.get(i))) {
        return false;
      }
    }
    return true;
  }
}
