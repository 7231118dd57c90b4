package org.pendant.desktop.session;

/**
 * Switch listener: hears when a session's controllers are exchanged, or another one of a cell is
 * shown, in the thread that does it.
 */
public interface SwitchListener {
  /** The controllers are about to be switched off, perhaps for good; they still work. */
  void switchingOff();

  /** Others run. */
  void switchedOn();

  /** Another controller of the cell is about to be shown; between two frames. */
  default void leaving() {}

  /** Another controller of the cell is shown; it has run all the time. */
  default void shown() {}
}
