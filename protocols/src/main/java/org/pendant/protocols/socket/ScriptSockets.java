package org.pendant.protocols.socket;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.SocketConnector;
import org.pendant.protocols.egress.HostPolicy;

/** Script sockets: opens the sockets of the scripts of one controller. */
public final class ScriptSockets implements SocketConnector, AutoCloseable {
  private final HostPolicy hostPolicy;
  private final Set<ScriptSocket> open = ConcurrentHashMap.newKeySet();

  /** Sockets that go no further than {@code reach}. */
  public ScriptSockets(HostPolicy hostPolicy) {
    this.hostPolicy = hostPolicy;
  }

  @Override
  public ExternalSocket open(String host, int port) {
    ScriptSocket socket =
        new ScriptSocket(
            () -> hostPolicy.connect(host, port, ScriptSocket.CONNECT_MS), open::remove);
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
