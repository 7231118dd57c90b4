package org.pendant.command;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.FrictionCurve;
import org.pendant.models.arm.Joints;

/** Robot page: the arms as the Markdown page docs/robots.md. */
final class RobotPage {
  private static final String INTRODUCTION =
      """
      # Robots

      The arms that Pendant knows. `pendant run --robot NAME` takes the id or the name, in capitals or
      not; without it a program runs on a UR5e. `pendant robots NAME` prints every number of one arm.
      `--robot my-arm.json` takes a file with the numbers of one arm instead: its layout is that of the
      files in models/src/main/resources/org/pendant/models/arm, all keys are needed, and its `id` is the
      model that the arm is one of, whose shape it has. A joint may also have `lagS`, how far its drive
      lags behind its target, 0 to 0.002 s; 0.00049 s without it. `pendant fit` writes such a file from
      recordings of your arm. Recordings keep the id, not the numbers.
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

      Makers publish none of these numbers. Those that are *measured* were fitted to public recordings of
      a UR3e, a UR5e and a UR10e: the inertia of the rotor as it is felt behind the gear, the torque of
      an ampere, and the current that friction takes at a speed v under a moment,

      ```text
      (coulomb + load |moment|) tanh(v / 0.0079 rad/s) + curved tanh(v / over) + viscous v
      ```

      That friction grows with the load was seen at the shoulder of the UR3e alone, in five moves.

      *Derived* numbers are those of a measured joint of the same size, friction as a torque. All others
      are *estimated*: rotor inertias follow the measured sizes on a log-log line and may be wrong by
      a factor of 1.5; friction is 5.2 % of the joint's largest torque, another 2.5 % that comes up to
      about 0.48 rad/s, and 3 % for each rad/s. Torque constants of one type differ by up to 3 % from
      arm to arm, those of wrists by 5 %; friction by 3 % from day to day. A program that compares
      motor currents with a threshold may need another one on a real arm.

      Provenance is that of rotor inertia, torque constant and friction, in this order.

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
      Stream<String> words = robot.trust().stream().map(Trust::words);
      table.row(Stream.concat(Stream.of(robot.arm().displayName()), words).toArray(String[]::new));
    }
    return table;
  }

  /** What the words in {@link #trust} mean, as far as they occur there. */
  private List<String> meanings() {
    List<Trust> all = robots.stream().flatMap(robot -> robot.trust().stream()).toList();
    return Trust.occurring(all).stream()
        .map(confidence -> "- *" + confidence.word() + "*: " + Trust.meaning(confidence))
        .toList();
  }

  private List<String> notes() {
    return robots.stream()
        .map(RobotDataSheet::arm)
        .filter(arm -> !arm.notes().isEmpty())
        .map(arm -> "- " + arm.displayName() + ": " + String.join("; ", arm.notes()))
        .toList();
  }

  /** Drives of joints that follow one another, from the largest torque that they give. */
  private record SizedDrive(double maxTorqueNm, Actuator drive) {}

  private static List<SizedDrive> drives(ArmDescription arm) {
    return IntStream.range(0, Joints.COUNT)
        .mapToObj(i -> new SizedDrive(arm.joints().get(i).maxTorqueNm(), arm.actuators().get(i)))
        .toList();
  }

  private Table drives() {
    Table table =
        new Table()
            .left("arm")
            .left("joint")
            .right("largest torque, Nm")
            .right("rotor inertia, kg m\u00b2")
            .right("torque constant, Nm/A")
            .right("coulomb, A")
            .right("curved, A")
            .right("over, rad/s")
            .right("viscous, A s/rad")
            .right("load, A/Nm")
            .left("provenance");
    Map<List<SizedDrive>, String> armsByDrives = new LinkedHashMap<>();
    for (RobotDataSheet robot : robots) {
      armsByDrives.merge(
          drives(robot.arm()), robot.arm().displayName(), (names, name) -> names + ", " + name);
    }
    armsByDrives.forEach((drives, names) -> addDrives(table, names, drives));
    return table;
  }

  private static void addDrives(Table table, String arms, List<SizedDrive> drives) {
    int first = 0;
    while (first < drives.size()) {
      SizedDrive each = drives.get(first);
      int last = first;
      while (last + 1 < drives.size() && drives.get(last + 1).equals(each)) {
        last++;
      }
      FrictionCurve friction = each.drive().friction();
      Actuator.Status status = each.drive().status();
      table.row(
          first == 0 ? arms : "",
          first == last ? Integer.toString(first) : first + " to " + last,
          Decimal.text(each.maxTorqueNm(), 1),
          Decimal.text(each.drive().rotorInertiaKgM2(), 4),
          Decimal.text(each.drive().torqueConstantNmPerA(), 3),
          Decimal.text(friction.coulombA(), 3),
          Decimal.text(friction.curvedA(), 3),
          Decimal.text(friction.curveSpeedRadPerS(), 3),
          Decimal.text(friction.viscousASPerRad(), 3),
          Decimal.text(friction.loadAPerNm(), 4),
          status.rotorInertia().word()
              + ", "
              + status.torqueConstant().word()
              + ", "
              + status.friction().word());
      first = last + 1;
    }
  }
}
