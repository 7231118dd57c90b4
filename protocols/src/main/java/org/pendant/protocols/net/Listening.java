package org.pendant.protocols.net;

import java.net.InetAddress;

/**
 * Where a server listens.
 *
 * @param name of the protocol, for messages, such as {@code Dashboard}
 * @param host address of the interface
 * @param port 0 for any free one
 * @param mostConnections one more is closed at once
 */
public record Listening(String name, InetAddress host, int port, int mostConnections) {
  /** How many peers a port takes unless told otherwise. */
  public static final int MOST_CONNECTIONS = 256;

  /** With the usual number of connections. */
  public Listening(String name, InetAddress host, int port) {
    this(name, host, port, MOST_CONNECTIONS);
  }
}
