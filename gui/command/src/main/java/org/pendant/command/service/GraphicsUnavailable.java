package org.pendant.command.service;

/** Failure to draw on this machine; the message says what is missing and how to get it. */
public final class GraphicsUnavailable extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * @param message what is missing
   */
  public GraphicsUnavailable(String message, Throwable cause) {
    super(message, cause);
  }
}
