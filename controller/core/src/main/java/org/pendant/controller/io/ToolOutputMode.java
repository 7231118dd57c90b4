package org.pendant.controller.io;

/** Tool output mode: what the two output pins of the tool connector are for (manual 18.52). */
public enum ToolOutputMode {
  /** Two digital outputs. */
  DIGITAL,
  /** Both pins together supply the tool. */
  DUAL_PIN_POWER
}
