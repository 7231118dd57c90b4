package org.pendant.controller.message;

/**
 * A message window that a program shows (manual 16.41).
 *
 * @param number popups and questions are counted together, from 1
 * @param timeS controller time when it was shown, s
 * @param title bytes, one {@code char} a byte
 * @param text bytes, one {@code char} a byte
 * @param blocking whether the program stands still until the operator answers
 */
public record Popup(
    long number, double timeS, String title, String text, Severity severity, boolean blocking) {

  /** How the window is dressed. */
  public enum Severity {
    MESSAGE,
    WARNING,
    ERROR
  }
}
