package org.pendant.controller.freedrive;

/** Freedrive holder: who lets the arm be guided. */
public enum FreedriveHolder {
  /** A program, by {@code freedrive_mode}. */
  PROGRAM,
  /** The operator at the screen. */
  HAND,
  /** An input with the freedrive action. */
  INPUT
}
