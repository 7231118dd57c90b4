package org.pendant.controller.state;

import org.pendant.controller.world.LinkDistances;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * Arm geometry: what follows from the joints of one snapshot. It is worked out on demand, and then
 * kept: many clients ask the same of a frame, most frames are not asked for. Any thread.
 */
public final class ArmGeometry {
  private final ArmState arm;
  private final ArmReadings readings;
  private final LinkDistance links;

  // Each is computed at most once by each thread that finds it missing; what they find is equal.
  private Pose actualTcp;
  private Pose targetTcp;
  private ToolMotion actual;
  private ToolMotion target;
  private Wrench fromCurrents;
  private Wrench baseWrench;
  private LinkDistances linkDistances;

  /** What follows from a snapshot's parts. */
  public ArmGeometry(ArmState arm, ArmReadings readings, LinkDistance links) {
    this.arm = arm;
    this.readings = readings;
    this.links = links;
  }

  /** The same with an arm elsewhere. */
  ArmGeometry of(ArmState elsewhere) {
    return new ArmGeometry(elsewhere, readings, links);
  }

  /**
   * How near the links of the arm are to one another, to objects that stand still, to other arms.
   */
  public LinkDistances linkDistances() {
    LinkDistances known = linkDistances;
    if (known == null) {
      known = links.of(arm);
      linkDistances = known;
    }
    return known;
  }

  /** Where the TCP is, in the base frame. */
  public Pose actualTcpInBase() {
    Pose known = actualTcp;
    if (known == null) {
      known = arm.actualTcpInBase();
      actualTcp = known;
    }
    return known;
  }

  /** Where the TCP should be, in the base frame. */
  public Pose targetTcpInBase() {
    Pose known = targetTcp;
    if (known == null) {
      known = arm.targetTcpInBase();
      targetTcp = known;
    }
    return known;
  }

  /** How tool and elbow move. */
  public ToolMotion actual() {
    ToolMotion known = actual;
    if (known == null) {
      known =
          motion(
              arm.actualPositionRad(), arm.actualSpeedRadPerS(), readings.accelerationRadPerS2());
      actual = known;
    }
    return known;
  }

  /** How tool and elbow should move. */
  public ToolMotion target() {
    ToolMotion known = target;
    if (known == null) {
      known =
          motion(
              arm.targetPositionRad(), arm.targetSpeedRadPerS(), arm.targetAccelerationRadPerS2());
      target = known;
    }
    return known;
  }

  private ToolMotion motion(Joints q, Joints qd, Joints qdd) {
    return ToolMotion.of(arm.kinematics(), q, qd, qdd, arm.tool().inFlange());
  }

  /**
   * The wrench on the flange that would explain the torques of the joints from outside, along the
   * axes of the base. Near a singularity it is smaller than the true one.
   */
  public Wrench flangeWrenchFromCurrents() {
    Wrench known = fromCurrents;
    if (known == null) {
      known = ArmForces.flangeWrenchOf(arm, readings.externalTorqueNm());
      fromCurrents = known;
    }
    return known;
  }

  /**
   * The wrench with which the base holds the arm with its declared payload in the target motion, at
   * its origin along its axes.
   */
  public Wrench targetBaseWrench() {
    Wrench known = baseWrench;
    if (known == null) {
      known = ArmForces.baseWrench(arm, readings.payload(), readings.mounting());
      baseWrench = known;
    }
    return known;
  }
}
