package org.pendant.command.service;

/** Failure to open the window; the message says what is missing. */
public final class DesktopUnavailable extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * @param message what is missing
   */
  public DesktopUnavailable(String message) {
    super(message);
  }

  /**
   * @param message what is missing
   */
  public DesktopUnavailable(String message, Throwable cause) {
    super(message, cause);
  }
}
