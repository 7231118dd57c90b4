package org.pendant.controller.safety;

/** Safety action: what the frame has to do after the safety functions have looked at it. */
public enum SafetyAction {
  NONE,
  /** Pause the program as the pause button does. */
  PAUSE,
  /** Stop the arm on its path and pause the program: stop category 2. */
  STOP_ON_PATH,
  /**
   * Stop the arm on its path and end the program: stop category 1. Power goes off by itself once
   * the target rests.
   */
  STOP_ON_PATH_THEN_OFF,
  /** End the program; power is off already: stop category 0. */
  OFF_NOW,
  /** A safeguard stop is over: a program that it paused continues. */
  RESUME
}
