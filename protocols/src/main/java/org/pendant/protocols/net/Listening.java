package org.pendant.protocols.net;

import java.net.InetAddress;

/**
 * Listening address: where a server listens.
 *
 * @param name of the protocol, for messages, such as {@code Dashboard}
 * @param host address of the interface
 * @param port 0 for any free one
 * @param mostConnections one more gets the place of a silent one, or none
 * @param idle how long a peer may say nothing
 */
public record Listening(
    String name, InetAddress host, int port, int mostConnections, IdleLimits idle) {
  /** How many peers a port takes unless told otherwise. */
  public static final int MAX_CONNECTIONS = 256;

  /** With the usual number of connections, which may be silent for ever. */
  public Listening(String name, InetAddress host, int port) {
    this(name, host, port, MAX_CONNECTIONS, IdleLimits.NONE);
  }

  /** With other limits for peers that say nothing. */
  public Listening with(IdleLimits limits) {
    return new Listening(name, host, port, mostConnections, limits);
  }
}
