package org.pendant.command.rpc;

/** RPC method: what a request asks for by its name. */
@FunctionalInterface
interface RpcMethod {
  /** Does it, and answers the result. */
  Object call(RpcParams params) throws RpcFailure;

  /** A method about one robot. */
  @FunctionalInterface
  interface OfRobot {
    /** Does it, and answers the result. */
    Object call(DrivenRobot robot, RpcParams params) throws RpcFailure;
  }
}
