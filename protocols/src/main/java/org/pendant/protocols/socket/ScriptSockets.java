package org.pendant.protocols.socket;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.outside.OutsideSocket;
import org.pendant.controller.outside.SocketDoor;
import org.pendant.protocols.reach.Reach;

/** Opens the sockets of the scripts of one controller. */
public final class ScriptSockets implements SocketDoor, AutoCloseable {
  private final Reach reach;
  private final Set<ScriptSocket> open = ConcurrentHashMap.newKeySet();

  /** Sockets that go no farther than {@code reach}. */
  public ScriptSockets(Reach reach) {
    this.reach = reach;
  }

  @Override
  public OutsideSocket open(String host, int port) {
    ScriptSocket socket =
        new ScriptSocket(() -> reach.connect(host, port, ScriptSocket.CONNECT_MS), open::remove);
    open.add(socket);
    socket.begin();
    return socket;
  }

  /** Closes all, and waits until what was left to be sent has gone out, a few seconds at most. */
  @Override
  public void close() {
    List<ScriptSocket> left = List.copyOf(open);
    left.forEach(ScriptSocket::close);
    left.forEach(ScriptSocket::awaitEnd);
  }
}
