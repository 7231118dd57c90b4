package org.pendant.protocols.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class PeriodicTasksTest {
  private static final long GIVE_UP_S = 20;
  private static final long INTERVAL_NS = 1000;

  private final BlockingQueue<String> logged = new LinkedBlockingQueue<>();
  private final PeriodicTasks tasks =
      new PeriodicTasks(
          Thread.ofPlatform().daemon().name("tested"),
          new PeerLog((level, text) -> logged.add(level + " " + text)));

  @AfterEach
  void close() {
    tasks.close();
  }

  @Test
  void aWatchdogThatThrowsIsLoggedOnceAndGoesOn() throws Exception {
    CountDownLatch rounds = new CountDownLatch(5);
    tasks.withPauses(
        "the watchdog",
        INTERVAL_NS,
        () -> {
          rounds.countDown();
          throw new IllegalStateException("broken");
        });
    assertTrue(rounds.await(GIVE_UP_S, TimeUnit.SECONDS));
    assertEquals(
        List.of(
            "ERROR the watchdog failed and continues: internal error:"
                + " java.lang.IllegalStateException: broken"),
        List.copyOf(logged));
  }

  @Test
  void aSenderThatRunsOutOfStackGoesOnToo() throws Exception {
    CountDownLatch rounds = new CountDownLatch(3);
    tasks.atRate(
        "the sender",
        INTERVAL_NS,
        () -> {
          rounds.countDown();
          throw new StackOverflowError();
        });
    assertTrue(rounds.await(GIVE_UP_S, TimeUnit.SECONDS));
  }

  @Test
  void aFaultThatComesBackIsLoggedAgain() throws Exception {
    AtomicInteger round = new AtomicInteger();
    tasks.atRate(
        "the sender",
        INTERVAL_NS,
        () -> {
          if (round.getAndIncrement() % 2 == 0) {
            throw new IllegalStateException("broken");
          }
        });
    String first = logged.poll(GIVE_UP_S, TimeUnit.SECONDS);
    assertEquals(first, logged.poll(GIVE_UP_S, TimeUnit.SECONDS));
  }

  @Test
  void aTaskThatFailsDisturbsNoOther() throws Exception {
    CountDownLatch rounds = new CountDownLatch(3);
    tasks.atRate(
        "the sender",
        INTERVAL_NS,
        () -> {
          throw new IllegalStateException("broken");
        });
    tasks.atRate("the other", INTERVAL_NS, rounds::countDown);
    assertTrue(rounds.await(GIVE_UP_S, TimeUnit.SECONDS));
  }
}
