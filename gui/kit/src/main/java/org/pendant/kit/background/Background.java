package org.pendant.kit.background;

import static org.pendant.kit.background.BackgroundTexts.text;

import java.awt.EventQueue;
import java.io.IOException;
import java.util.function.Consumer;
import org.pendant.kit.fault.Faults;

/**
 * Background work: does what is slow outside of the dispatch thread and hands the result to it.
 * Every task is followed by either its result or a reason, whatever it throws.
 */
public final class Background {
  private Background() {}

  /** Something slow. */
  @FunctionalInterface
  public interface Task<T> {
    /** Does it; off the dispatch thread. */
    T run() throws IOException;
  }

  /**
   * Runs a task.
   *
   * @param then takes its result, on the dispatch thread
   * @param failed takes the reason if it fails, on the dispatch thread: what the task says, or that
   *     it was a fault of ours, which is reported besides
   */
  public static <T> void run(Task<T> task, Consumer<T> then, Consumer<IOException> failed) {
    Thread.ofVirtual()
        .name("background")
        .start(
            () -> {
              try {
                T result = task.run();
                EventQueue.invokeLater(() -> then.accept(result));
              } catch (IOException e) {
                EventQueue.invokeLater(() -> failed.accept(e));
              } catch (RuntimeException | Error fault) {
                IOException reason = new IOException(text("internalError", fault), fault);
                EventQueue.invokeLater(() -> failed.accept(reason));
                Faults.report(fault);
              }
            });
  }
}
