package org.pendant.gui.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.util.function.Consumer;

/** Does what is slow outside of the dispatch thread and hands the result to it. */
final class Background {
  private Background() {}

  /** Something slow. */
  @FunctionalInterface
  interface Task<T> {
    T run() throws IOException;
  }

  /**
   * Runs a task.
   *
   * @param then takes its result, on the dispatch thread
   * @param failed takes the reason if it fails, on the dispatch thread
   */
  static <T> void run(Task<T> task, Consumer<T> then, Consumer<IOException> failed) {
    Thread.ofVirtual()
        .name("background")
        .start(
            () -> {
              try {
                T result = task.run();
                EventQueue.invokeLater(() -> then.accept(result));
              } catch (IOException e) {
                EventQueue.invokeLater(() -> failed.accept(e));
              }
            });
  }
}
