package org.pendant.command;

import java.util.List;
import java.util.stream.Collectors;
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
    return List.of(
        new Trust("lengths", status.kinematics()),
        new Trust("masses", status.masses()),
        new Trust("inertias", status.inertias()),
        new Trust("limits", status.jointLimits()),
        new Trust("drives", status.actuators()),
        new Trust("shape", shape.status()));
  }

  /** The groups that were not taken from this very model, e.g. {@code limits, drives}. */
  String uncertain() {
    return trust().stream()
        .filter(each -> !each.confidence().ofThisModel())
        .map(Trust::group)
        .collect(Collectors.joining(", "));
  }
}
