package org.pendant.controller.external;

import static org.pendant.controller.external.ExternalTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.script.value.ScriptError;

/**
 * External connections of the running program: sockets by name and servers of remote procedures by
 * number. All threads of a program share them, and they end with it. Owned by the frame loop.
 */
public final class ExternalConnections {
  /** Most sockets, and most servers of remote procedures, that one program may have. */
  public static final int MOST = 128;

  private final Connectors connectors;
  private final Map<String, ExternalSocket> sockets = new HashMap<>();
  private final List<RpcLink> servers = new ArrayList<>();

  /** Connections by way of {@code doors}. */
  public ExternalConnections(Connectors connectors) {
    this.connectors = connectors;
  }

  /**
   * Begins to connect a socket; one that has the name already is closed.
   *
   * @throws ScriptError when there is no way out, or there are too many
   */
  public ExternalSocket open(String name, String host, int port) throws ScriptError {
    close(name);
    if (sockets.size() >= MOST) {
      throw tooMany("manySockets");
    }
    ExternalSocket socket = connectors.sockets().open(host, port);
    sockets.put(name, socket);
    return socket;
  }

  /** The socket of that name. */
  public Optional<ExternalSocket> socket(String name) {
    return Optional.ofNullable(sockets.get(name));
  }

  /** Closes the socket of that name; no effect when there is none. */
  public void close(String name) {
    ExternalSocket socket = sockets.remove(name);
    if (socket != null) {
      socket.close();
    }
  }

  /** As {@link #close(String)}, unless the name has meanwhile been given to another socket. */
  public void close(String name, ExternalSocket socket) {
    if (socket.equals(sockets.get(name))) {
      close(name);
    }
  }

  /**
   * Makes a connection to a server of remote procedures.
   *
   * @return its number, from 1
   * @throws ScriptError when there is no way out, the address is wrong, or there are too many
   */
  public int openServer(String url) throws ScriptError {
    if (servers.size() >= MOST) {
      throw tooMany("manyRpcHandles");
    }
    servers.add(connectors.rpc().open(url));
    return servers.size();
  }

  /**
   * The server with that number.
   *
   * @throws ScriptError when it is of an earlier program
   */
  public RpcLink server(int number) throws ScriptError {
    if (number > servers.size()) {
      throw new ScriptError("rpc-closed", text("oldRpcHandle"));
    }
    return servers.get(number - 1);
  }

  /** Closes everything. */
  public void programEnded() {
    sockets.values().forEach(ExternalSocket::close);
    sockets.clear();
    servers.forEach(RpcLink::close);
    servers.clear();
  }

  private static ScriptError tooMany(String refusal) {
    return new ScriptError("too-many-connections", text(refusal, MOST));
  }
}
