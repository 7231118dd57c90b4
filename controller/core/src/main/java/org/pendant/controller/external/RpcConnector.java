package org.pendant.controller.external;

import org.pendant.script.value.ScriptError;

/** Connector to servers of remote procedures. */
@FunctionalInterface
public interface RpcConnector {
  /**
   * A connection, not yet tried.
   *
   * @param url {@code http://host:port/path}, or {@code host:port} for a stream of packets (manual
   *     18.40)
   * @throws ScriptError when the address has another form, or must not be reached
   */
  RpcLink open(String url) throws ScriptError;
}
