package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Call;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Socket arguments: what the functions for sockets have in common. */
final class SocketArguments {
  static final String MODULE = "interfaces";
  static final String NAME = "socket_name";

  /** The socket that is meant when none is named. */
  static final Value DEFAULT_NAME = Value.of("socket_0");

  static final String TIMEOUT = "timeout";
  static final double DEFAULT_TIMEOUT_S = 2;

  /** Beyond this a wait is one for ever, s: more than a century. */
  private static final double MAX_S = 4e9;

  private SocketArguments() {}

  /** The socket that argument {@code index} names; says so once where it is not open. */
  static Optional<ExternalSocket> socket(Call<ControlBox> call, String function, int index)
      throws ScriptError {
    String name = call.text(index);
    Optional<ExternalSocket> socket =
        call.host()
            .links()
            .outside()
            .socket(name)
            .filter(each -> each.stage() != ExternalSocket.Stage.CONNECTING);
    if (socket.isEmpty()) {
      call.host().log().warnOnce(text("socketNotOpen", function, quoted(name)));
    }
    return socket;
  }

  /**
   * The frame at which a timeout is over, counted as waits are; one of 0 or less never is (manual
   * 18.57).
   */
  static long deadline(Call<ControlBox> call, int index) throws ScriptError {
    double timeoutS = call.number(index);
    if (Double.isNaN(timeoutS)) {
      throw call.refuse(index, text("seconds"));
    }
    return timeoutS <= 0 || timeoutS > MAX_S
        ? Long.MAX_VALUE
        : call.frame() + FrameTime.framesFor(timeoutS);
  }

  static String quoted(String bytes) {
    return '"' + (bytes.length() > 80 ? bytes.substring(0, 80) + "..." : bytes) + '"';
  }
}
