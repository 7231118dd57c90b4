package org.pendant.controller.state;

/**
 * Runtime state: what the program does, and the arm because of it; codes are those of the
 * interfaces.
 */
public enum RuntimeState {
  /** The program has been stopped, and the arm comes to rest. */
  STOPPING(0),
  STOPPED(1),
  PLAYING(2),
  /** The program is paused, and the arm comes to rest. */
  PAUSING(3),
  PAUSED(4),
  /** The program continues, and the arm speeds up again. */
  RESUMING(5);

  private final int code;

  RuntimeState(int code) {
    this.code = code;
  }

  /** The number that interfaces report, 0 to 5. */
  public int code() {
    return code;
  }
}
