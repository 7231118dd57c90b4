package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.LinkMass;

/** Robot sheet: one arm in full, for the terminal. */
final class RobotSheet {
  static final List<String> JOINTS =
      List.of("base", "shoulder", "elbow", "wrist 1", "wrist 2", "wrist 3");
  private static final int NOTE_COLUMNS = 76;

  private final RobotDataSheet robot;
  private final ArmDescription arm;

  RobotSheet(RobotDataSheet robot) {
    this.robot = robot;
    arm = robot.arm();
  }

  List<String> lines() {
    ArmDescription.Status status = arm.status();
    List<String> lines = new ArrayList<>();
    lines.add(arm.displayName() + " (" + arm.id() + "), " + arm.series().displayName());
    lines.add("payload " + robot.payloadKg() + " kg, reach " + robot.reachMm() + " mm");
    String lengths = "Lengths (Denavit-Hartenberg), m: " + status.kinematics().word();
    lines.addAll(section(lengths, lengths().aligned()));
    String limits = "Limits of the joints: " + status.jointLimits().word();
    lines.addAll(section(limits, limits().aligned()));
    lines.addAll(section("Drives, seen from the joint", drives().aligned()));
    lines.addAll(section("Where the numbers of the drives come from", driveTrust().aligned()));
    String links = "Links: " + status.masses().word();
    lines.addAll(section(links, links().aligned()));
    lines.addAll(section("Where the numbers come from", trust().aligned()));
    if (!arm.notes().isEmpty()) {
      lines.addAll(section("Notes", notes()));
    }
    return lines;
  }

  private static List<String> section(String heading, List<String> content) {
    List<String> lines = new ArrayList<>();
    lines.add("");
    lines.add(heading);
    content.forEach(line -> lines.add("  " + line));
    return lines;
  }

  private List<String> notes() {
    List<String> lines = new ArrayList<>();
    for (String note : arm.notes()) {
      String bullet = "- ";
      for (String line : Paragraph.wrap(note, NOTE_COLUMNS)) {
        lines.add(bullet + line);
        bullet = "  ";
      }
    }
    return lines;
  }

  private Table lengths() {
    DhLengths dh = arm.dh();
    Table table = new Table();
    List.of("d1", "a2", "a3", "d4", "d5", "d6").forEach(table::right);
    table.row(
        metres(dh.d1()),
        metres(dh.a2()),
        metres(dh.a3()),
        metres(dh.d4()),
        metres(dh.d5()),
        metres(dh.d6()));
    return table;
  }

  private Table limits() {
    Table table =
        new Table()
            .left("joint")
            .right("from, deg")
            .right("to, deg")
            .right("speed, deg/s")
            .right("torque, Nm");
    for (int i = 0; i < JOINTS.size(); i++) {
      JointLimits limits = arm.joints().get(i);
      table.row(
          JOINTS.get(i),
          limits.unlimited() ? "no end" : degrees(limits.minRad()),
          limits.unlimited() ? "no end" : degrees(limits.maxRad()),
          degrees(limits.maxSpeedRadPerS()),
          Decimal.text(limits.maxTorqueNm(), 1));
    }
    return table;
  }

  private Table drives() {
    Table table =
        new Table()
            .left("joint")
            .right("rotor, kg m\u00b2")
            .right("Nm/A")
            .right("Coulomb, A")
            .right("curved, A")
            .right("over, rad/s")
            .right("viscous, A s/rad")
            .right("load, A/Nm");
    for (int i = 0; i < JOINTS.size(); i++) {
      Actuator drive = arm.actuators().get(i);
      table.row(
          JOINTS.get(i),
          Decimal.text(drive.rotorInertiaKgM2(), 4),
          Decimal.text(drive.torqueConstantNmPerA(), 3),
          Decimal.text(drive.friction().coulombA(), 3),
          Decimal.text(drive.friction().curvedA(), 3),
          Decimal.text(drive.friction().curveSpeedRadPerS(), 3),
          Decimal.text(drive.friction().viscousASPerRad(), 3),
          Decimal.text(drive.friction().loadAPerNm(), 4));
    }
    return table;
  }

  private Table driveTrust() {
    Table table =
        new Table().left("joint").left("rotor inertia").left("torque constant").left("friction");
    for (int i = 0; i < JOINTS.size(); i++) {
      Actuator.Status status = arm.actuators().get(i).status();
      table.row(
          JOINTS.get(i),
          status.rotorInertia().word(),
          status.torqueConstant().word(),
          status.friction().word());
    }
    return table;
  }

  private Table links() {
    Table table =
        new Table()
            .left("link")
            .right("mass, kg")
            .right("centre of mass x, m")
            .right("y, m")
            .right("z, m");
    double sumKg = 0;
    for (LinkMass link : arm.links()) {
      table.row(
          link.name().replace('_', ' '),
          kilograms(link.massKg()),
          metres(link.comXM()),
          metres(link.comYM()),
          metres(link.comZM()));
      sumKg += link.massKg();
    }
    table.row("together", kilograms(sumKg), "", "", "");
    return table;
  }

  private Table trust() {
    Table table = new Table().left("group").left("status").left("which means");
    for (Trust trust : robot.trust()) {
      table.row(trust.group(), trust.words(), trust.meanings());
    }
    return table;
  }

  private static String metres(double lengthM) {
    return Decimal.text(lengthM, 6);
  }

  private static String kilograms(double massKg) {
    return Decimal.text(massKg, 4);
  }

  private static String degrees(double angleRad) {
    return Decimal.text(Math.toDegrees(angleRad), 1);
  }
}
