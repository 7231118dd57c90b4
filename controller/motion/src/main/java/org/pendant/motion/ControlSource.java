package org.pendant.motion;

/**
 * Control source: what commands the arm when no trajectory does: a hand, or torques of the program.
 */
final class ControlSource {
  private boolean guided;
  private boolean torqueDriven;

  /** The program has given torques for the frame that comes. */
  private boolean torqueGiven;

  /** A hand guides the arm. */
  boolean guided() {
    return guided;
  }

  void setGuided(boolean byHand) {
    guided = byHand;
  }

  /** Torques drive the arm; after the step, whether in this frame. */
  boolean torqueDriven() {
    return torqueDriven;
  }

  /** Whether there are torques for the frame that comes. */
  boolean torqueGiven() {
    return torqueGiven;
  }

  /** Torques drive the arm in the frame that comes. */
  void giveTorque() {
    torqueDriven = true;
    torqueGiven = true;
  }

  /** The frame comes for which torques were given, if any were; returns whether. */
  boolean useTorque() {
    boolean given = torqueGiven;
    torqueGiven = false;
    return given;
  }

  /** The torques for the frame that comes do not count. */
  void withdrawTorque() {
    torqueGiven = false;
  }

  /** No torques drive the arm any more. */
  void endTorque() {
    torqueDriven = false;
  }

  /** Nothing leads the arm. */
  void clear() {
    guided = false;
    torqueDriven = false;
    torqueGiven = false;
  }
}
