package org.pendant.script.vm;

import org.pendant.script.value.ScriptError;

/** Thread failure: a thread failed; {@link #thread} tells where. */
final class ThreadFailure extends Exception {
  private static final long serialVersionUID = 1L;
  private final transient ScriptThread thread;
  private final ScriptError error;

  ThreadFailure(ScriptThread thread, ScriptError error) {
    super(error.getMessage(), error, false, false);
    this.thread = thread;
    this.error = error;
  }

  ScriptThread thread() {
    return thread;
  }

  ScriptError error() {
    return error;
  }
}
