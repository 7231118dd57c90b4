package org.pendant.editors.dap;

import java.util.concurrent.CompletableFuture;

/**
 * Stop kinds: all that can stop a program of a session.
 *
 * @param lines breakpoints on lines
 * @param functions breakpoints on functions
 * @param data breakpoints on values
 * @param failures which failures stop it
 */
record StopKinds(
    BreakpointRequests lines,
    FunctionBreakpoints functions,
    DataBreakpoints data,
    ExceptionFilters failures) {

  /** Another debugger is there, which has no breakpoints yet. */
  void anotherDebugger() {
    lines.anotherDebugger();
  }

  /** Another program is there: it stops where the client has asked for before. */
  CompletableFuture<Boolean> launched() {
    failures.apply();
    data.apply();
    functions.launched();
    lines.launched();
    return lines.install();
  }
}
