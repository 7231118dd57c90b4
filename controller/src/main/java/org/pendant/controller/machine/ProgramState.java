package org.pendant.controller.machine;

/** Whether a program runs. */
public enum ProgramState {
  STOPPED,
  RUNNING,
  PAUSED
}
