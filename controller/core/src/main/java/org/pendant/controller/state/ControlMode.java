package org.pendant.controller.state;

/** Control mode: what the drives of the arm follow; codes are those of the primary interface. */
public enum ControlMode {
  /** Target positions. */
  POSITION(0),
  /** A person who guides the arm by hand. */
  TEACH(1),
  /** Target positions that give way to a force. */
  FORCE(2),
  /** Torques from a program. */
  TORQUE(3);

  private final int code;

  ControlMode(int code) {
    this.code = code;
  }

  /** The number that interfaces report, 0 to 3. */
  public int code() {
    return code;
  }
}
