package org.pendant.desktop.debug;

import org.pendant.script.debug.Debugger;

/**
 * Scope: a call in which names mean something.
 *
 * @param thread handle of its thread, 0 for the main thread
 * @param depth 1 for the outermost call
 * @param function that is called
 */
public record Scope(int thread, int depth, String function) {
  /** Where global variables are looked at and changed. */
  static final Scope GLOBAL = new Scope(Debugger.MAIN, Debugger.OUTERMOST, "");
}
