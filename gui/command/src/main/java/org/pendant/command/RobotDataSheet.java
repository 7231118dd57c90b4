package org.pendant.command;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.shape.ArmShape;
import org.pendant.models.shape.ArmShapes;

/**
 * Robot data sheet: what is known of one arm, in the units of a data sheet.
 *
 * @param arm its description
 * @param shape what it looks like
 */
record RobotDataSheet(ArmDescription arm, ArmShape shape) {

  static RobotDataSheet load(String id) {
    return new RobotDataSheet(ArmLibrary.load(id), ArmShapes.load(id));
  }

  /** Every arm of the library, in its order. */
  static List<RobotDataSheet> all() {
    return ArmLibrary.ids().stream().map(RobotDataSheet::load).toList();
  }

  String payloadKg() {
    return Decimal.text(arm.payloadKg(), 2);
  }

  String reachMm() {
    return Decimal.text(1000 * arm.reachM(), 0);
  }

  /** Largest speeds of the six joints, base first, deg/s. */
  String speedsDegPerS() {
    return arm.joints().stream()
        .map(joint -> Decimal.text(Math.toDegrees(joint.maxSpeedRadPerS()), 1))
        .collect(Collectors.joining(" "));
  }

  /** The groups of numbers and how far each can be trusted. */
  List<Trust> trust() {
    ArmDescription.Status status = arm.status();
    return Stream.of(
            Stream.of(
                new Trust("lengths", status.kinematics()),
                new Trust("masses", status.masses()),
                new Trust("inertias", status.inertias()),
                new Trust("limits", status.jointLimits())),
            driveTrust().stream(),
            Stream.of(new Trust("shape", shape.status())))
        .flatMap(each -> each)
        .toList();
  }

  /** The same for the numbers of the drives. */
  List<Trust> driveTrust() {
    return List.of(
        Trust.ofJoints("rotors", driveStatus().map(Actuator.Status::rotorInertia)),
        Trust.ofJoints("torque constants", driveStatus().map(Actuator.Status::torqueConstant)),
        Trust.ofJoints("friction", driveStatus().map(Actuator.Status::friction)));
  }

  private Stream<Actuator.Status> driveStatus() {
    return arm.actuators().stream().map(Actuator::status);
  }

  /**
   * The groups that were not all taken from this very model, e.g. {@code limits, drives}; the
   * numbers of the drives count as one group.
   */
  List<String> uncertain() {
    List<Trust> ofDrives = driveTrust();
    return trust().stream()
        .filter(each -> !each.ofThisModel())
        .map(each -> ofDrives.contains(each) ? "drives" : each.group())
        .distinct()
        .toList();
  }
}
