package org.pendant.models.arm;

import java.util.List;

/**
 * Everything the program knows about one arm model.
 *
 * @param id the word that selects it, such as {@code ur5e}
 * @param displayName the name for people
 * @param dh lengths of the kinematic chain
 * @param joints limits of the six joints, base first
 * @param links masses of the six moving links, shoulder first
 * @param payloadKg rated payload, kg
 * @param reachM rated reach, m
 * @param status how far the numbers can be trusted
 */
public record ArmDescription(
    String id,
    String displayName,
    DhLengths dh,
    List<JointLimits> joints,
    List<LinkMass> links,
    double payloadKg,
    double reachM,
    Status status) {
  /**
   * Trust in each group of numbers.
   *
   * @param kinematics of the lengths
   * @param dynamics of masses and inertias
   * @param jointLimits of ranges, speeds and torques
   */
  public record Status(Confidence kinematics, Confidence dynamics, Confidence jointLimits) {}

  /**
   * Checks the counts and copies the lists.
   *
   * @throws IllegalArgumentException if there are not six joints and six links
   */
  public ArmDescription {
    joints = List.copyOf(joints);
    links = List.copyOf(links);
    if (joints.size() != Joints.COUNT || links.size() != Joints.COUNT) {
      throw new IllegalArgumentException(
          id
              + ": has "
              + joints.size()
              + " joints and "
              + links.size()
              + " links, must have "
              + Joints.COUNT
              + " of each");
    }
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
