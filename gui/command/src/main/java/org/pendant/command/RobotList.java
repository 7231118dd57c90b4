package org.pendant.command;

import java.util.List;

/** Robot list: all arms, one line each. */
final class RobotList {
  private RobotList() {}

  static List<String> lines(List<RobotDataSheet> robots) {
    Table table =
        new Table()
            .left("id")
            .left("name")
            .left("series")
            .right("payload")
            .right("reach")
            .left("joint speeds, deg/s")
            .left("derived, assumed or estimated");
    for (RobotDataSheet robot : robots) {
      table.row(
          robot.arm().id(),
          robot.arm().displayName(),
          robot.arm().series().displayName(),
          robot.payloadKg() + " kg",
          robot.reachMm() + " mm",
          robot.speedsDegPerS(),
          robot.uncertain());
    }
    return table.aligned();
  }
}
