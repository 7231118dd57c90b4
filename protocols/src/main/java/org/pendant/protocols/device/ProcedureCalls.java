package org.pendant.protocols.device;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import org.apache.xmlrpc.XmlRpcException;
import org.pendant.controller.Deadline;
import org.pendant.controller.Robot;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Reply;
import org.pendant.protocols.http.HttpCall;
import org.pendant.protocols.http.HttpReply;
import org.pendant.protocols.http.HttpService;
import org.pendant.protocols.http.HttpStatus;
import org.pendant.protocols.xmlrpc.CallAnswer;
import org.pendant.protocols.xmlrpc.CallReader;
import org.pendant.script.value.ScriptError;

/** Procedure calls to devices of the cell by XML-RPC. Each call takes a frame. */
final class ProcedureCalls implements HttpService {
  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final String POST = "POST";
  private static final int NOT_XML_RPC = 1;
  private static final int REFUSED = 2;

  private final Robot robot;
  private final int port;

  /**
   * Calls of one port.
   *
   * @param port at which programs reach the devices
   */
  ProcedureCalls(Robot robot, int port) {
    this.robot = robot;
    this.port = port;
  }

  @Override
  public HttpReply answer(HttpCall call) throws InterruptedException {
    return call.method().equals(POST)
        ? new HttpReply(HttpStatus.OK, "text/xml", answer(call.body()))
        : new HttpReply(HttpStatus.METHOD_NOT_ALLOWED, "text/plain", "only POST\n", List.of(POST));
  }

  private String answer(ByteBuffer body) {
    try {
      CallReader.Call call = CallReader.read(body);
      Reply reply =
          robot.ask(
              new WorldCommand.CallDevice(port, call.method(), CallAnswer.parameters(call)),
              Deadline.orNever(PATIENCE));
      return reply instanceof Reply.Returned returned
          ? CallAnswer.of(returned.value())
          : CallAnswer.fault(REFUSED, call.method() + ": " + reply.complaint().orElse("no answer"));
    } catch (XmlRpcException e) {
      return CallAnswer.fault(NOT_XML_RPC, "the call is not XML-RPC");
    } catch (ScriptError e) {
      return CallAnswer.fault(REFUSED, e.getMessage());
    }
  }
}
