package org.pendant.protocols.modbus;

import java.time.Duration;
import java.util.List;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.Reply;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.modbus.RefusedRequest.Reason;

/** Signal handler: reads and writes a controller's signals for one client. */
final class SignalHandler implements Answers.Box {
  /** A frame takes 2 ms: who gets no answer for this long speaks to a box that has stopped. */
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  private final Controller controller;
  private final String client;

  SignalHandler(Controller controller, String client) {
    this.controller = controller;
    this.client = client;
  }

  @Override
  public ControllerState state() {
    return controller.state();
  }

  @Override
  public void write(List<SignalWrite> writes) throws RefusedRequest {
    if (!(answer(new Command.WriteSignals(client, writes)) instanceof Reply.Done)) {
      throw new RefusedRequest(Reason.FAILURE);
    }
  }

  private Reply answer(Command command) throws RefusedRequest {
    try {
      return controller.post(command).await(PATIENCE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new RefusedRequest(Reason.FAILURE);
    }
  }
}
