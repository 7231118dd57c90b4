package org.pendant.script.vm;

/** Whether a program runs. */
public enum ProgramState {
  STOPPED,
  RUNNING,
  PAUSED
}
