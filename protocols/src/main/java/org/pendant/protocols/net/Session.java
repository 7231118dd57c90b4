package org.pendant.protocols.net;

import java.nio.ByteBuffer;

/**
 * Session: one peer's conversation. {@link #received} and {@link #closed} are called by the
 * connection's own thread, never at the same time; both may wait.
 */
public interface Session {
  /**
   * Bytes have come, cut anywhere. What is left unread in the buffer is lost: a session keeps the
   * start of an unfinished message itself.
   *
   * @throws ProtocolException if the connection has to end for what came; it is logged
   */
  void received(ByteBuffer bytes) throws ProtocolException;

  /** The connection has ended, by whichever side. Called once. */
  default void closed() {}
}
