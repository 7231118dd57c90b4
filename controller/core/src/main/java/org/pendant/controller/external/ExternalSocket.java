package org.pendant.controller.external;

/** External socket: a TCP connection of a script, used by the frame loop. No method waits. */
public interface ExternalSocket {
  /** How far a connection has come. */
  enum Stage {
    CONNECTING,
    OPEN,
    /** It never came about. */
    FAILED,
    /** It was there, and is closed or lost. */
    CLOSED
  }

  Stage stage();

  /** Why it is {@link Stage#FAILED}; empty otherwise. */
  String failure();

  /**
   * Leaves bytes to be sent.
   *
   * @param bytes not changed any more by the caller
   * @return false when it is not open, or the peer has not read what was sent before
   */
  boolean send(byte[] bytes);

  /** What the peer has sent and the program has not taken. */
  ReceivedBytes received();

  /** Whether the peer lives in robot time, so that no clock has to wait for it. */
  default boolean inRobotTime() {
    return false;
  }

  /** Ends it, once what was left to be sent has gone out. */
  void close();
}
