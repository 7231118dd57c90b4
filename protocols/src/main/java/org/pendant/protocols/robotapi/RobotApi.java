package org.pendant.protocols.robotapi;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.protocols.http.BodyLimit;
import org.pendant.protocols.http.HttpCall;
import org.pendant.protocols.http.HttpReply;
import org.pendant.protocols.http.HttpService;
import org.pendant.protocols.http.HttpStatus;
import org.pendant.protocols.server.RemoteControl;

/** Robot API: finds out what a request asks for, and whether its sender may. */
final class RobotApi implements HttpService {
  /** In front of every path. */
  static final String ADDRESS = "/universal-robots/robot-api";

  private static final String FORBIDDEN = "Forbidden - Operation Not Allowed";

  private final RobotApiHandler robotApiHandler;
  private final ProgramTransfers transfers;
  private final RemoteControl remote;

  RobotApi(RobotApiHandler robotApiHandler, ProgramTransfers transfers, RemoteControl remote) {
    this.robotApiHandler = robotApiHandler;
    this.transfers = transfers;
    this.remote = remote;
  }

  @Override
  public BodyLimit bodyLimit(String method, String path) {
    return Operation.of(method, path(path)).filter(Operation::transfers).isPresent()
        ? transfers.limit()
        : BodyLimit.USUAL;
  }

  @Override
  public HttpReply answer(HttpCall call) throws InterruptedException {
    String path = path(call.path());
    Optional<Operation> operation = Operation.of(call.method(), path);
    if (operation.isEmpty()) {
      List<String> methods =
          Arrays.stream(Operation.values())
              .filter(each -> each.isAt(path))
              .map(Operation::method)
              .toList();
      return methods.isEmpty()
          ? ApiReply.refused(HttpStatus.NOT_FOUND, "Not Found", "there is no " + call.path())
          : ApiReply.otherMethod(methods);
    }
    Operation wanted = operation.get();
    if ((wanted.changes() || wanted.transfers()) && call.headers().containsKey("origin")) {
      // a page in the browser of a person who can reach this port, by whatever name
      return ApiReply.refused(HttpStatus.FORBIDDEN, FORBIDDEN, "web pages may not control it");
    }
    if (wanted.acts() && !remote.mayControl()) {
      return ApiReply.refused(
          HttpStatus.FORBIDDEN, FORBIDDEN, "the robot is in local control, must be in remote");
    }
    return switch (wanted) {
      case UPLOAD -> transfers.add(call);
      case UPDATE -> transfers.replace(call);
      case DOWNLOAD -> transfers.give(wanted.nameIn(path));
      default -> robotApiHandler.answer(wanted, call.body());
    };
  }

  /** Below the address of the API; empty if it is not there. A slash at the end does not count. */
  private static String path(String path) {
    String rest = path.startsWith(ADDRESS + "/") ? path.substring(ADDRESS.length()) : "";
    return rest.endsWith("/") ? rest.substring(0, rest.length() - 1) : rest;
  }
}
