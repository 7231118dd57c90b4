package org.pendant.protocols.eip.service;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import org.apache.xmlrpc.XmlRpcException;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.protocols.http.HttpCall;
import org.pendant.protocols.http.HttpReply;
import org.pendant.protocols.http.HttpService;
import org.pendant.protocols.http.HttpStatus;
import org.pendant.protocols.xmlrpc.CallAnswer;
import org.pendant.protocols.xmlrpc.CallReader;

/** Assembly calls: what can be called (manual 21.1.1, 21.1.2). */
final class AssemblyCalls implements HttpService {
  private static final String POST = "POST";
  private static final int NOT_XML_RPC = 1;
  private static final int UNKNOWN_METHOD = 2;
  private static final int WRONG_PARAMETERS = 3;

  private final Configuration configuration;

  AssemblyCalls(Configuration configuration) {
    this.configuration = configuration;
  }

  @Override
  public HttpReply answer(HttpCall call) throws InterruptedException {
    return call.method().equals(POST)
        ? new HttpReply(HttpStatus.OK, "text/xml", answer(call.body()))
        : new HttpReply(HttpStatus.METHOD_NOT_ALLOWED, "text/plain", "only POST\n", List.of(POST));
  }

  /** Carries a call out; answers the XML that is sent back. */
  String answer(ByteBuffer call) throws InterruptedException {
    try {
      CallReader.Call read = CallReader.read(call);
      return switch (read.method()) {
        case "add_configuration" -> bool(add(read.parameters()));
        case "is_instance_connected" -> connected(read.parameters());
        default ->
            CallAnswer.fault(
                UNKNOWN_METHOD, "must be called as add_configuration or is_instance_connected");
      };
    } catch (XmlRpcException e) {
      return CallAnswer.fault(NOT_XML_RPC, "the call is not XML-RPC");
    }
  }

  /** A wrong parameter is no fault but just refused. */
  private boolean add(List<Object> parameters) throws InterruptedException {
    Optional<AssemblyPair> pair = pair(parameters);
    return pair.isPresent() && configuration.add(pair.get());
  }

  private static Optional<AssemblyPair> pair(List<Object> parameters) {
    if (parameters.size() == 4
        && parameters.get(0) instanceof Integer toPlcId
        && parameters.get(1) instanceof Integer toPlcBytes
        && parameters.get(2) instanceof Integer fromPlcId
        && parameters.get(3) instanceof Integer fromPlcBytes) {
      try {
        return Optional.of(new AssemblyPair(toPlcId, toPlcBytes, fromPlcId, fromPlcBytes));
      } catch (IllegalArgumentException e) {
        return Optional.empty();
      }
    }
    return Optional.empty();
  }

  private String connected(List<Object> parameters) {
    return parameters.size() == 1 && parameters.getFirst() instanceof Integer instance
        ? bool(configuration.connected(instance))
        : CallAnswer.fault(
            WRONG_PARAMETERS, "is_instance_connected takes one int, a PLC to robot instance");
  }

  private static String bool(boolean value) {
    return "<?xml version=\"1.0\"?><methodResponse><params><param><value><boolean>"
        + (value ? 1 : 0)
        + "</boolean></value></param></params></methodResponse>";
  }
}
