package org.pendant.command;

import org.pendant.controller.Robot;
import org.pendant.controller.box.MessageCommand;
import org.pendant.protocols.net.PeerLog;

/** Server log: the controller's log as servers write it. */
final class ServerLog {
  private ServerLog() {}

  /** Writes to the log of {@code robot}. */
  static PeerLog of(Robot robot) {
    return new PeerLog(
        (level, text) -> {
          // a line that finds no place among 1024 commands of one frame is lost
          var _ = robot.submit(new MessageCommand.WriteLog(level, text));
        });
  }
}
