package org.pendant.script.vm;

/** Size error: a program exceeds one of the machine's sizes. */
final class ProgramTooLarge extends RuntimeException {
  private static final long serialVersionUID = 1L;

  ProgramTooLarge(String message) {
    super(message);
  }
}
