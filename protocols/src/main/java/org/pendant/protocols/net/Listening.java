package org.pendant.protocols.net;

import java.net.InetAddress;
import java.util.function.Supplier;
import org.pendant.protocols.wire.Dissector;

/**
 * Listening address: where a server listens.
 *
 * @param name of the protocol, for messages, such as {@code Dashboard}
 * @param host address of the interface
 * @param port 0 for any free one
 * @param mostConnections one more gets the place of a silent one, or none
 * @param idle how long a peer may say nothing
 * @param dissector reads a connection for people, a new one for each
 */
public record Listening(
    String name,
    InetAddress host,
    int port,
    int mostConnections,
    IdleLimits idle,
    Supplier<Dissector> dissector) {
  /** How many peers a port takes unless told otherwise. */
  public static final int MAX_CONNECTIONS = 256;

  /** With the usual number of connections, which may be silent for ever. */
  public Listening(String name, InetAddress host, int port) {
    this(name, host, port, MAX_CONNECTIONS, IdleLimits.NONE, Dissector::raw);
  }

  /** With other limits for peers that say nothing. */
  public Listening with(IdleLimits limits) {
    return new Listening(name, host, port, mostConnections, limits, dissector);
  }

  /** With connections that people can read. */
  public Listening readBy(Supplier<Dissector> reader) {
    return new Listening(name, host, port, mostConnections, idle, reader);
  }
}
