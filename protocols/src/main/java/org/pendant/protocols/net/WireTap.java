package org.pendant.protocols.net;

import java.nio.ByteBuffer;

/**
 * Wire tap: is told of everything that goes over the connections of a port. Any thread, also the
 * one of the frames, so nothing here may wait.
 */
public interface WireTap {
  /** A peer has connected; nothing has been sent yet. */
  void opened(WireEnd connection);

  /**
   * Bytes have come.
   *
   * @param before how many had come before
   * @param bytes are others after the call; the position is not to be moved
   */
  void received(WireEnd connection, long before, ByteBuffer bytes);

  /**
   * Bytes go out, or wait for it.
   *
   * @param before how many went before
   * @param bytes never change
   */
  void sent(WireEnd connection, long before, byte[] bytes);

  /** The conversation has ended. */
  void closed(WireEnd connection);
}
