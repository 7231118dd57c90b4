package org.pendant.controller.vm;

/** Whether a program runs. */
public enum ProgramState {
  STOPPED,
  RUNNING,
  PAUSED
}
