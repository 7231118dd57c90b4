package org.pendant.project.program.script;

/**
 * A move in a thread of its own, while the program looks in each frame whether something ends it.
 * Begins with {@link #start} or {@link #startMove}; then {@link #watch}, the endings, and {@link
 * #close}.
 */
final class WatchedMove {
  private final ScriptLines lines;
  private final String done;
  private final String handle;
  private final String thread;

  WatchedMove(ScriptContext context) {
    lines = context.lines();
    done = context.names().numbered("move_done");
    handle = context.names().numbered("move_handle");
    thread = context.names().numbered("move_thread");
  }

  /** Writes a thread with one move that nothing else comes between, and what starts it. */
  void startMove(Runnable moving) {
    start(
        () -> {
          lines.line("enter_critical");
          moving.run();
          lines.line("exit_critical");
        });
  }

  /** Writes a thread with whatever {@code moving} writes, and what starts it. */
  void start(Runnable moving) {
    lines.aside(
        () -> {
          lines.open("thread " + thread + "():");
          moving.run();
          lines.line(done + " = True");
          lines.close();
        });
    lines.line("global " + done + " = False");
    lines.line("global " + handle + " = run " + thread + "()");
  }

  /** Opens the loop that watches; each ending in it breaks out. */
  void watch() {
    lines.open("while (True):");
  }

  /** An expression for whether the move has come to its own end. */
  String done() {
    return done;
  }

  /** Opens what happens once a condition holds; {@link #leave} ends it. */
  void when(String condition) {
    lines.open("if " + condition + ":");
  }

  /** Ends the move before its time: {@code stop} brings the arm to rest. */
  void stop(String stop) {
    kill();
    lines.line(stop);
  }

  /** Ends the thread, wherever it is. */
  void kill() {
    lines.line("kill " + handle);
  }

  /** Waits for the last of a move that has come to its end. */
  void join() {
    lines.line("join " + handle);
  }

  /** Goes on behind the loop. */
  void leave() {
    lines.last("break");
    lines.close();
  }

  /** Ends the loop. */
  void close() {
    lines.line("sync()");
    lines.close();
  }
}
