package org.pendant.controller.builtin;

import java.util.Optional;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.SocketRead;
import org.pendant.script.function.Wait;
import org.pendant.script.value.Value;

/** Wait of a script thread for what it reads from a socket. */
final class SocketReadWait implements Wait {
  private final ExternalSocket socket;
  private final SocketRead read;
  private final long deadline;

  /** Waits until frame {@code deadline}. */
  SocketReadWait(ExternalSocket socket, SocketRead read, long deadline) {
    this.socket = socket;
    this.read = read;
    this.deadline = deadline;
  }

  /** A read from a socket that is not open takes its frame as well, and fails. */
  static Wait notOpen(SocketRead read) {
    return frame -> Optional.of(read.failed());
  }

  @Override
  public Optional<Value> poll(long frame) {
    // first: what arrives after this is left for the next frame, what arrived before is read
    boolean ended = socket.received().ended();
    Optional<Value> value = read.from(socket.received());
    return value.isEmpty() && (ended || frame >= deadline) ? Optional.of(read.failed()) : value;
  }

  @Override
  public boolean outside() {
    return !socket.inRobotTime();
  }
}
