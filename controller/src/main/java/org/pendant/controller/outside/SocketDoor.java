package org.pendant.controller.outside;

import org.pendant.controller.value.ScriptError;

/** Opens TCP connections. */
@FunctionalInterface
public interface SocketDoor {
  /**
   * Begins to connect and comes back at once.
   *
   * @param host name or address, one {@code char} a byte
   * @param port 1 to 65535
   * @throws ScriptError when this controller cannot connect to anything
   */
  OutsideSocket open(String host, int port) throws ScriptError;
}
