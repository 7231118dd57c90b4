package org.pendant.command;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Confidence;
import org.pendant.models.arm.Joints;

/** Robot page: the arms as the Markdown page docs/robots.md. */
final class RobotPage {
  private static final String INTRODUCTION =
      """
      # Robots

      The arms that Pendant knows. `pendant run --robot NAME` takes the id or the name, in capitals or
      not; without it a program runs on a UR5e. `pendant robots NAME` prints every number of one arm.
      This page is generated: `./pendant robots --markdown > docs/robots.md`.

      """;

  private static final String AFTER_ARMS =
      """

      Speeds are the limits of the joints from base to wrist 3. Every joint turns 360 degrees either
      way, wrist 3 of the UR3 and UR3e without end. Payloads are today's ratings; several arms came
      out with a lower one. Lengths are the nominal ones: a real arm deviates a little, and brings a
      calibration of its own.

      ## Where the numbers come from

      """;

  private static final String AFTER_TRUST =
      """

      Lengths are the Denavit-Hartenberg parameters, masses include the centres of mass, limits are
      range, speed and torque of the joints. How fast a joint can accelerate is not published, so
      no description says it.

      """;

  private static final String DRIVES =
      """

      ## Drives

      No source that we know states friction, rotor inertia or torque constant of these joints, so all
      numbers of the drives are estimates of ours. They go by the largest torque of a joint: friction
      that does not depend on the speed is 5 % of it, friction that does is another 5 % at 1 rad/s,
      and the torque of an ampere grows with the size of the joint. The inertia of the rotor, as it is
      felt behind the gear, is one round number for all. Motor currents, friction and the mass matrix
      with rotors are therefore plausible, not exact: a program that compares them with a threshold
      needs another threshold on a real arm.

      """;

  private static final String SHAPES =
      """

      ## Shapes

      Housings and tubes are cylinders, measured on public 3D drawings. There was none to measure of
      the UR8 Long, UR15 and UR18: their lengths are their own, their cross-sections those of the UR20
      made smaller in the ratio of d4 (0.1824 m to 0.2010 m).
      """;

  private final List<RobotDataSheet> robots;

  RobotPage(List<RobotDataSheet> robots) {
    this.robots = List.copyOf(robots);
  }

  String markdown() {
    StringBuilder page = new StringBuilder(1 << 13);
    page.append(INTRODUCTION);
    append(page, arms().markdown());
    page.append(AFTER_ARMS);
    append(page, trust().markdown());
    page.append('\n');
    append(page, meanings());
    page.append(AFTER_TRUST);
    append(page, notes());
    page.append(DRIVES);
    append(page, drives().markdown());
    page.append(SHAPES);
    return page.toString();
  }

  private static void append(StringBuilder page, List<String> lines) {
    lines.forEach(line -> page.append(line).append('\n'));
  }

  private Table arms() {
    Table table =
        new Table()
            .left("id")
            .left("name")
            .left("series")
            .right("payload, kg")
            .right("reach, mm")
            .left("speeds, deg/s");
    for (RobotDataSheet robot : robots) {
      ArmDescription arm = robot.arm();
      table.row(
          "`" + arm.id() + "`",
          arm.displayName(),
          arm.series().displayName(),
          robot.payloadKg(),
          robot.reachMm(),
          robot.speedsDegPerS());
    }
    return table;
  }

  private Table trust() {
    Table table = new Table().left("arm");
    robots.getFirst().trust().forEach(each -> table.left(each.group()));
    for (RobotDataSheet robot : robots) {
      Stream<String> words = robot.trust().stream().map(each -> each.confidence().word());
      table.row(Stream.concat(Stream.of(robot.arm().displayName()), words).toArray(String[]::new));
    }
    return table;
  }

  /** What the words in {@link #trust} mean, as far as they occur there. */
  private List<String> meanings() {
    return Arrays.stream(Confidence.values())
        .filter(this::occurs)
        .map(confidence -> "- *" + confidence.word() + "*: " + Trust.meaning(confidence))
        .toList();
  }

  private boolean occurs(Confidence confidence) {
    return robots.stream()
        .flatMap(robot -> robot.trust().stream())
        .anyMatch(each -> each.confidence() == confidence);
  }

  private List<String> notes() {
    return robots.stream()
        .map(RobotDataSheet::arm)
        .filter(arm -> !arm.notes().isEmpty())
        .map(arm -> "- " + arm.displayName() + ": " + String.join("; ", arm.notes()))
        .toList();
  }

  /** A drive and the largest torque of the joint that it is in. */
  private record SizedDrive(double maxTorqueNm, Actuator drive) {}

  private Table drives() {
    Table table =
        new Table()
            .right("joint's largest torque, Nm")
            .right("rotor inertia, kg m\u00b2")
            .right("Coulomb friction, Nm")
            .right("viscous friction, Nm s/rad")
            .right("torque constant, Nm/A");
    robots.stream()
        .map(RobotDataSheet::arm)
        .flatMap(RobotPage::drives)
        .distinct()
        .sorted(Comparator.comparingDouble(SizedDrive::maxTorqueNm))
        .forEach(
            each ->
                table.row(
                    Decimal.text(each.maxTorqueNm(), 1),
                    Decimal.text(each.drive().rotorInertiaKgM2(), 3),
                    Decimal.text(each.drive().coulombNm(), 2),
                    Decimal.text(each.drive().viscousNmSPerRad(), 2),
                    Decimal.text(each.drive().torqueConstantNmPerA(), 2)));
    return table;
  }

  private static Stream<SizedDrive> drives(ArmDescription arm) {
    return IntStream.range(0, Joints.COUNT)
        .mapToObj(i -> new SizedDrive(arm.joints().get(i).maxTorqueNm(), arm.actuators().get(i)));
  }
}
