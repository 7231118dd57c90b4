package org.pendant.sweep.engine;

/** Engine exception: the variants cannot be run, for a reason outside of them; for people. */
public final class EngineException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * @param message what cannot be, and why
   */
  public EngineException(String message) {
    super(message);
  }

  /**
   * @param message what cannot be, and why
   * @param cause what it came from
   */
  public EngineException(String message, Throwable cause) {
    super(message, cause);
  }
}
