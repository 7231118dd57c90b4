package org.pendant.protocols.device;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.pendant.controller.Deadline;
import org.pendant.controller.Robot;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Reply;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.Session;

/** Device session: a client that talks to a device of the cell. Each message takes a frame. */
final class DeviceSession implements Session {
  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private final Connection connection;
  private final Robot robot;
  private final int port;
  private final long number;

  DeviceSession(Connection connection, Robot robot, int port, long number) {
    this.connection = connection;
    this.robot = robot;
    this.port = port;
    this.number = number;
  }

  @Override
  public void received(ByteBuffer bytes) {
    String said = StandardCharsets.ISO_8859_1.decode(bytes).toString();
    String answer = told(said);
    if (answer.isEmpty() && !said.endsWith("\n")) {
      // a message without its newline has ended when nothing follows it
      answer = told("");
    }
    if (!answer.isEmpty()) {
      connection.send(answer.getBytes(StandardCharsets.ISO_8859_1));
    }
  }

  private String told(String bytes) {
    Reply reply =
        robot.ask(new WorldCommand.TellDevice(port, number, bytes), Deadline.orLater(PATIENCE));
    return reply instanceof Reply.Told told ? told.bytes() : "";
  }

  @Override
  public void closed() {
    var _ = robot.submit(new WorldCommand.LeaveDevice(port, number));
  }
}
