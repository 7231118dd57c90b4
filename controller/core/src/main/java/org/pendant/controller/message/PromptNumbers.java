package org.pendant.controller.message;

/** Prompt numbers: counts popups and questions together, so that a number names one of either. */
public final class PromptNumbers {
  private long newest;

  /** The next number, from 1. */
  long next() {
    newest++;
    return newest;
  }
}
