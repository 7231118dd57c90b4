package org.pendant.controller.external;

import java.util.List;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Link to one server of remote procedures. Calls are made one after the other. */
public interface RpcLink {
  /** Tries whether the server is there; the result is none. */
  Pending connect();

  /**
   * Calls a procedure.
   *
   * @param method with its dots
   * @param arguments not changed any more by the caller
   * @throws ScriptError when an argument cannot be sent
   */
  Pending call(String method, List<Value> arguments) throws ScriptError;

  /** Ends the connection; another call makes a new one. */
  void disconnect();

  /** Ends the connection and the calls that are under way. */
  void close();
}
