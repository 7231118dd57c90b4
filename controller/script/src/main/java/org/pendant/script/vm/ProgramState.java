package org.pendant.script.vm;

/** Program state: whether a program runs. */
public enum ProgramState {
  STOPPED,
  RUNNING,
  PAUSED
}
