package org.pendant.kit.background;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.kit.fault.ReportedFaults;

@Timeout(value = 30, unit = TimeUnit.SECONDS)
final class BackgroundTest {
  @Test
  void aResultIsHandedToTheDispatchThread() {
    CompletableFuture<Boolean> there = new CompletableFuture<>();
    Background.run(
        () -> 7,
        result -> there.complete(EventQueue.isDispatchThread()),
        there::completeExceptionally);
    assertTrue(there.join());
  }

  @Test
  void troubleWithAFileIsHandedOnAsItIs() {
    try (ReportedFaults faults = new ReportedFaults()) {
      assertEquals(
          "no such file",
          failureOf(
              () -> {
                throw new IOException("no such file");
              }));
      assertEquals(0, faults.all().size());
    }
  }

  @Test
  void aFaultOfOursEndsTheWorkAndIsReported() {
    try (ReportedFaults faults = new ReportedFaults()) {
      String why =
          failureOf(
              () -> {
                throw new IllegalStateException("no node 7");
              });
      assertEquals("internal error, java.lang.IllegalStateException: no node 7", why);
      await(faults);
      assertEquals("no node 7", faults.all().getFirst().getMessage());
    }
  }

  @Test
  void aStackThatIsTooDeepIsAFaultLikeAnyOther() {
    try (ReportedFaults faults = new ReportedFaults()) {
      assertTrue(failureOf(() -> deep(1, Integer.MAX_VALUE)).contains("StackOverflowError"));
      await(faults);
    }
  }

  private static void await(ReportedFaults faults) {
    while (faults.all().isEmpty()) {
      Thread.onSpinWait();
    }
  }

  private static String failureOf(Background.Task<Integer> task) {
    CompletableFuture<String> why = new CompletableFuture<>();
    Background.run(
        task, result -> why.complete("none"), failed -> why.complete(failed.getMessage()));
    return why.join();
  }

  private static int deep(int depth, int deepest) {
    return depth == deepest ? depth : 1 + deep(depth + 1, deepest);
  }
}
