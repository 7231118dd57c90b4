package org.pendant.desktop.program;

/** Arm teacher: where arms are moved by hand to teach places. */
public interface ArmTeacher {

  /**
   * Lets the user move the arm.
   *
   * @param what is taught, such as {@code Waypoint_1}
   * @param accepted runs when the arm is there
   * @param left runs when people do not want to any more
   */
  void teach(String what, Runnable accepted, Runnable left);
}
