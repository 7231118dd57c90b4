package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;

/** Robot list: all arms, one line each. */
final class RobotList {
  private RobotList() {}

  static List<String> lines(List<RobotDataSheet> robots) {
    Table table =
        new Table()
            .left(text("armId"))
            .left(text("armName"))
            .left(text("armSeries"))
            .right(text("armPayload"))
            .right(text("armReach"))
            .left(text("armSpeeds"))
            .left(text("armUncertain"));
    for (RobotDataSheet robot : robots) {
      table.row(
          robot.arm().id(),
          robot.arm().displayName(),
          robot.arm().series().displayName(),
          robot.payloadKg() + " kg",
          robot.reachMm() + " mm",
          robot.speedsDegPerS(),
          uncertain(robot));
    }
    return table.aligned();
  }

  private static String uncertain(RobotDataSheet robot) {
    return robot.uncertain().stream()
        .map(RobotList::shown)
        .reduce((first, next) -> text("groupsListed", first, next))
        .orElse("");
  }

  /** A group of numbers, as data sheets name it. */
  private static String shown(String group) {
    return switch (group) {
      case "lengths" -> text("groupLengths");
      case "masses" -> text("groupMasses");
      case "inertias" -> text("groupInertias");
      case "limits" -> text("groupLimits");
      case "drives" -> text("groupDrives");
      case "shape" -> text("groupShape");
      default -> group;
    };
  }
}
