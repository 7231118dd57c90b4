package org.pendant.protocols.server;

import java.time.Duration;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.Reply;

/**
 * Has commands carried out that are refused only while too many others wait: asks again for a
 * while. For threads that may wait.
 */
public final class RetriedCommands {
  /** A frame takes 2 ms: who gets no answer for this long speaks to a box whose time stands. */
  public static final Duration PATIENCE = Duration.ofSeconds(5);

  /** When to ask again, ms. */
  private static final long AGAIN_MS = 2;

  private final Controller controller;

  /** For commands to {@code controller}. */
  public RetriedCommands(Controller controller) {
    this.controller = controller;
  }

  /** Asks once. */
  @FunctionalInterface
  private interface Attempt {
    Reply make(Duration patience) throws InterruptedException;
  }

  /** Has it carried out within {@link #PATIENCE}, or never; answers whether it was. */
  public boolean inTimeOrNever(Command command) throws InterruptedException {
    return retried(patience -> controller.post(command).await(patience));
  }

  /**
   * Has it carried out within {@link #PATIENCE}, or later where time stands still; answers whether
   * it was so far.
   */
  public boolean eventually(Command command) throws InterruptedException {
    return retried(
        patience -> {
          try {
            return controller.submit(command).get(patience.toNanos(), TimeUnit.NANOSECONDS);
          } catch (TimeoutException e) {
            return new Reply.Refused("the controller does not answer");
          } catch (ExecutionException e) {
            throw new IllegalStateException(e);
          }
        });
  }

  private static boolean retried(Attempt attempt) throws InterruptedException {
    long endNs = System.nanoTime() + PATIENCE.toNanos();
    for (long leftNs = PATIENCE.toNanos(); leftNs > 0; leftNs = endNs - System.nanoTime()) {
      if (attempt.make(Duration.ofNanos(leftNs)) instanceof Reply.Done) {
        return true;
      }
      TimeUnit.MILLISECONDS.sleep(AGAIN_MS);
    }
    return false;
  }
}
