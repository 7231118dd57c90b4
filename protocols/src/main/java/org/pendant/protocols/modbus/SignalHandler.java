package org.pendant.protocols.modbus;

import java.time.Duration;
import java.util.List;
import org.pendant.controller.Deadline;
import org.pendant.controller.Robot;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.modbus.RefusedRequest.Reason;

/** Signal handler: reads and writes a controller's signals for one client. */
final class SignalHandler implements Answers.Box {
  /** A frame takes 2 ms: who gets no answer for this long speaks to a box that has stopped. */
  private static final Deadline IN_TIME = Deadline.orNever(Duration.ofSeconds(5));

  private final Robot robot;
  private final String client;

  SignalHandler(Robot robot, String client) {
    this.robot = robot;
    this.client = client;
  }

  @Override
  public ControllerState state() {
    return robot.state();
  }

  @Override
  public void write(List<SignalWrite> writes) throws RefusedRequest {
    if (!(robot.ask(new IoCommand.WriteSignals(client, writes), IN_TIME) instanceof Reply.Done)) {
      throw new RefusedRequest(Reason.FAILURE);
    }
  }
}
