package org.pendant.protocols.modbus;

import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.Reply;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.modbus.RefusedRequest.Reason;

/** A controller's signals for one client. */
final class SignalDesk implements Answers.Box {
  /** A frame takes 2 ms: who gets no answer for this long speaks to a box that has stopped. */
  private static final long PATIENCE_S = 5;

  private final Controller controller;
  private final String client;

  SignalDesk(Controller controller, String client) {
    this.controller = controller;
    this.client = client;
  }

  @Override
  public ControllerState state() {
    return controller.state();
  }

  @Override
  public void write(List<SignalWrite> writes) throws RefusedRequest {
    Reply reply = await(controller.submit(new Command.WriteSignals(client, writes)));
    if (!(reply instanceof Reply.Done)) {
      throw new RefusedRequest(Reason.FAILURE);
    }
  }

  private static Reply await(Future<Reply> reply) throws RefusedRequest {
    try {
      return reply.get(PATIENCE_S, TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      throw new RefusedRequest(Reason.FAILURE);
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new RefusedRequest(Reason.FAILURE);
    }
  }
}
