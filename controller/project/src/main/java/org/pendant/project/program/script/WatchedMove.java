package org.pendant.project.program.script;

import org.pendant.project.program.ProgramNode;

/**
 * Watched move in a thread of its own, while the program looks in each frame whether something ends
 * it. Begins with {@link #startMove} or {@link #startNodes}; then {@link #watch}, the endings, and
 * {@link #close}.
 */
final class WatchedMove {
  private final ScriptLines lines;
  private final String flag;
  private final String handle;
  private final String thread;

  /** For a node, whose number its names have. */
  WatchedMove(ScriptContext context, ProgramNode node) {
    lines = context.lines();
    String number = "_" + lines.number(node);
    flag = context.names().unique("move_thread_flag" + number, "move_thread_flag");
    handle = context.names().unique("move_thread_han" + number, "move_thread_han");
    thread = context.names().unique("move_thread" + number, "move_thread");
  }

  /** Writes a thread with one move that nothing else comes between, and what starts it. */
  void startMove(Runnable moving) {
    start(
        () -> {
          lines.line("enter_critical");
          marked(moving);
          lines.line("exit_critical");
        });
  }

  /** Writes a thread with whatever {@code moving} writes, and what starts it. */
  void startNodes(Runnable moving) {
    start(() -> marked(moving));
  }

  private void start(Runnable moving) {
    lines.line("global " + flag + " = 0");
    lines.open("thread " + thread + "():");
    moving.run();
    lines.close();
    lines.line(flag + " = 0");
    lines.line(handle + " = run " + thread + "()");
  }

  private void marked(Runnable moving) {
    lines.line(flag + " = 1");
    moving.run();
    lines.line(flag + " = 2");
  }

  /** Opens the loop that watches; each ending in it breaks out. */
  void watch() {
    lines.open("while (True):");
  }

  /** A condition for whether the move has come to its own end. */
  String done() {
    return "(" + flag + " > 1)";
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

  /** Continues after the loop. */
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
