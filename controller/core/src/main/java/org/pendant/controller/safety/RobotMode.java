package org.pendant.controller.safety;

/**
 * Robot mode: how far the arm is switched on; names and codes are those of the controller's
 * interfaces.
 */
public enum RobotMode {
  NO_CONTROLLER(-1),
  DISCONNECTED(0),
  CONFIRM_SAFETY(1),
  BOOTING(2),
  POWER_OFF(3),
  POWER_ON(4),
  /** Powered, on its brakes. */
  IDLE(5),
  /** Powered, without brakes, to be pushed about by hand. */
  BACKDRIVE(6),
  /** Powered, without brakes, following its target: programs can run. */
  RUNNING(7),
  UPDATING_FIRMWARE(8);

  private final int code;

  RobotMode(int code) {
    this.code = code;
  }

  /** The number that interfaces report, -1 to 8. */
  public int code() {
    return code;
  }
}
