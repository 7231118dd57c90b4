package org.pendant.protocols.net;

/** Protocol error: what a peer sent cannot be understood, and the connection has to end. */
public final class ProtocolException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * A mistake of the peer.
   *
   * @param message what was found and what was expected, without the peer's name
   */
  public ProtocolException(String message) {
    super(message);
  }
}
