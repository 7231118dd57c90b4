package org.pendant.desktop.session;

/** Switch listener: hears when a session's controller is exchanged, in the thread that does it. */
public interface SwitchListener {
  /** The controller is about to be switched off, perhaps for good; it still works. */
  void switchingOff();

  /** Another one runs. */
  void switchedOn();
}
