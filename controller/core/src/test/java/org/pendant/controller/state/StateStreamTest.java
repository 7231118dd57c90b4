package org.pendant.controller.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;

class StateStreamTest {
  private static final long GIVE_UP_S = 20;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final StateStream.Subscription follower = controller.feed().follow();

  @Test
  void handsOutEveryFrameInTurnFromTheNextOn() throws Exception {
    for (int i = 0; i < 5; i++) {
      controller.advance();
    }
    for (long frame = 1; frame <= 5; frame++) {
      assertEquals(frame, follower.take().frame());
    }
    assertEquals(0, follower.missed());
  }

  @Test
  void wakesWhoWaits() throws Exception {
    CountDownLatch started = new CountDownLatch(1);
    CompletableFuture<Long> taken = new CompletableFuture<>();
    Thread waiting =
        Thread.ofVirtual()
            .start(
                () -> {
                  started.countDown();
                  try {
                    taken.complete(follower.take().frame());
                  } catch (InterruptedException e) {
                    taken.completeExceptionally(e);
                  }
                });
    started.await();
    controller.advance();
    assertEquals(1, taken.get(GIVE_UP_S, TimeUnit.SECONDS));
    waiting.join();
  }

  @Test
  void knowsWhetherSomebodyNeedsFramesOnTime() {
    follower.close();
    assertFalse(controller.feed().followed());
    AtomicBoolean needed = new AtomicBoolean();
    AtomicInteger wakes = new AtomicInteger();
    controller.feed().wakeBy(wakes::incrementAndGet);
    try (StateStream.Subscription patient = controller.feed().follow(needed::get)) {
      assertEquals(1, wakes.get());
      assertFalse(controller.feed().followed());
      needed.set(true);
      assertTrue(controller.feed().followed());
      assertFalse(patient.closed());
    }
    assertFalse(controller.feed().followed());
    controller.feed().followedByMore();
    assertEquals(2, wakes.get());
  }

  @Test
  void leavesOutTheOldestForWhoFallsFarBehind() throws Exception {
    int frames = StateStream.KEPT + 10;
    for (int i = 0; i < frames; i++) {
      controller.advance();
    }
    assertEquals(11, follower.take().frame());
    assertEquals(12, follower.take().frame());
    assertEquals(10, follower.missed());
  }

  @Test
  void closingEndsTheWait() throws Exception {
    CountDownLatch started = new CountDownLatch(1);
    CompletableFuture<Boolean> ended = new CompletableFuture<>();
    Thread.ofVirtual()
        .start(
            () -> {
              started.countDown();
              try {
                follower.take();
                ended.complete(follower.closed());
              } catch (InterruptedException e) {
                ended.completeExceptionally(e);
              }
            });
    started.await();
    follower.close();
    assertTrue(ended.get(GIVE_UP_S, TimeUnit.SECONDS));
  }
}
