package org.pendant.controller.io;

/** Watchdog action: what happens when an input is not written often enough (manual 18.41). */
public enum WatchdogAction {
  /** The log says so. */
  IGNORE,
  /** The program pauses. */
  PAUSE,
  /** The program ends. */
  STOP
}
