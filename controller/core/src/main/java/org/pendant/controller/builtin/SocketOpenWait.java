package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Wait;
import org.pendant.script.value.Value;

/** Wait of a script thread for a connection (manual 18.56). */
final class SocketOpenWait implements Wait {
  private static final int MAX_S = 2;

  private final ControlBox box;
  private final String name;
  private final ExternalSocket socket;
  private final String host;
  private final int port;
  private final long deadline;

  /**
   * Waits from frame {@code frame} on.
   *
   * @param host where to, for messages, and so the port
   */
  SocketOpenWait(
      ControlBox box, String name, ExternalSocket socket, String host, int port, long frame) {
    this.box = box;
    this.name = name;
    this.socket = socket;
    this.host = host;
    this.port = port;
    deadline = frame + FrameTime.framesFor(MAX_S);
  }

  @Override
  public Optional<Value> poll(long frame) {
    return switch (socket.stage()) {
      case OPEN -> Optional.of(Value.of(true));
      // opened, and lost or closed since: of the two only the first is a connection that came about
      case CLOSED ->
          Optional.of(
              Value.of(box.links().outside().socket(name).filter(socket::equals).isPresent()));
      case FAILED -> failed(socket.failure());
      case CONNECTING -> frame < deadline ? Optional.empty() : failed(text("noAnswer", MAX_S));
    };
  }

  private Optional<Value> failed(String why) {
    box.log().warnOnce(text("openFailed", SocketArguments.quoted(host), port, why));
    cancel();
    return Optional.of(Value.of(false));
  }

  @Override
  public boolean outside() {
    return !socket.inRobotTime();
  }

  @Override
  public void cancel() {
    box.links().outside().close(name, socket);
  }
}
