package org.pendant.protocols.trace;

import java.net.InetSocketAddress;
import org.pendant.protocols.net.WireEnd;

/**
 * Peers of a connection.
 *
 * @param port name of the port, such as {@code RTDE}
 * @param local its address and number
 * @param remote the client's
 */
public record Peers(String port, InetSocketAddress local, InetSocketAddress remote) {
  static Peers of(WireEnd connection) {
    return new Peers(connection.portName(), connection.local(), connection.peer());
  }

  /** The client as people write it, {@code 127.0.0.1:53422}. */
  public String client() {
    return remote.getAddress().getHostAddress() + ":" + remote.getPort();
  }
}
