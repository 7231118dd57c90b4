package org.pendant.controller.io;

/**
 * Input action: what a high level of an input does by itself (manual 19.3 to 19.5, 19.12, 19.14).
 */
public enum InputAction {
  /** Nothing. */
  DEFAULT,
  /** The arm can be guided by hand. */
  FREEDRIVE
}
