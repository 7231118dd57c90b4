package org.pendant.command;

import org.pendant.controller.Controller;
import org.pendant.controller.box.MessageCommand;
import org.pendant.protocols.net.PeerLog;

/** The controller's log as servers write it. */
final class ServerLog {
  private ServerLog() {}

  /** Writes to the log of {@code controller}. */
  static PeerLog of(Controller controller) {
    return new PeerLog(
        (level, text) -> {
          // a line that finds no place among 1024 commands of one frame is lost
          var _ = controller.submit(new MessageCommand.WriteLog(level, text));
        });
  }
}
