package org.pendant.desktop.shell;

import java.awt.EventQueue;
import java.util.function.BooleanSupplier;

/** Tests that do on the dispatch thread what people do in a window. */
final class DispatchThread {
  private DispatchThread() {}

  /** Does something there. */
  static void run(Runnable action) throws Exception {
    EventQueue.invokeAndWait(action);
  }

  /** Waits until something is so; asked there, each time after what was waiting there. */
  static void await(BooleanSupplier until) throws Exception {
    boolean[] so = {false};
    while (!so[0]) {
      EventQueue.invokeAndWait(() -> so[0] = until.getAsBoolean());
    }
  }
}
