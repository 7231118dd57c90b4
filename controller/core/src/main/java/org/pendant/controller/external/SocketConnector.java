package org.pendant.controller.external;

import org.pendant.script.value.ScriptError;

/** Connector that opens TCP connections. */
@FunctionalInterface
public interface SocketConnector {
  /**
   * Begins to connect and comes back at once.
   *
   * @param host name or address, one {@code char} a byte
   * @param port 1 to 65535
   * @throws ScriptError when this controller cannot connect to anything
   */
  ExternalSocket open(String host, int port) throws ScriptError;
}
