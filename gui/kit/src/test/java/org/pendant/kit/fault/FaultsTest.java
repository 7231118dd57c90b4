package org.pendant.kit.fault;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.Timer;
import org.junit.jupiter.api.Test;

final class FaultsTest {
  @Test
  void aTimerGoesOnAfterItsTurnHasThrown() throws Exception {
    CountDownLatch turns = new CountDownLatch(3);
    handleByDispatchThread((thread, fault) -> {});
    Timer timer =
        Faults.timer(
            1,
            () -> {
              turns.countDown();
              throw new IllegalStateException("turn " + turns.getCount());
            });
    timer.start();
    try {
      assertTrue(turns.await(20, TimeUnit.SECONDS), "the timer has stopped");
    } finally {
      timer.stop();
      handleByDispatchThread(null);
    }
  }

  private static void handleByDispatchThread(Thread.UncaughtExceptionHandler handler)
      throws Exception {
    EventQueue.invokeAndWait(() -> Thread.currentThread().setUncaughtExceptionHandler(handler));
  }

  @Test
  void aGuardedPartLeavesItsFaultToTheHandlerOfTheThread() throws InterruptedException {
    List<Throwable> reported = new ArrayList<>();
    List<String> done = new ArrayList<>();
    Thread thread =
        Thread.ofPlatform()
            .uncaughtExceptionHandler((where, fault) -> reported.add(fault))
            .start(
                () -> {
                  Faults.guard(
                      () -> {
                        throw new StackOverflowError("deep");
                      });
                  done.add("the next part");
                });
    thread.join();
    assertEquals(List.of("the next part"), done);
    assertEquals("deep", reported.getFirst().getMessage());
  }
}
