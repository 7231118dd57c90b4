package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.kit.fault.ReportedFaults;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class SaveQueueTest {
  private static final Path FILE = Path.of("a.script");

  private final SaveQueue queue = new SaveQueue();
  private final List<String> done = new ArrayList<>();

  @Test
  void aSaveBeginsOnlyAfterTheOneBeforeItWasTold() throws Exception {
    CountDownLatch slow = new CountDownLatch(1);
    DispatchThread.run(
        () -> {
          add(FILE, "first", () -> await(slow));
          add(FILE, "second", () -> {});
          add(Path.of("b.script"), "other file", () -> {});
        });
    DispatchThread.await(() -> !done.isEmpty());
    assertEquals(List.of("other file"), done);
    slow.countDown();
    DispatchThread.await(() -> done.size() == 3);
    assertEquals(List.of("other file", "first", "second"), done);
  }

  @Test
  void theSameFileByAnotherNameWaitsToo() throws Exception {
    CountDownLatch slow = new CountDownLatch(1);
    DispatchThread.run(
        () -> {
          add(FILE, "first", () -> await(slow));
          add(Path.of("folder/../a.script").toAbsolutePath(), "second", () -> {});
          assertEquals(1, queue.underWay().size());
        });
    slow.countDown();
    DispatchThread.await(() -> done.size() == 2);
    assertEquals(List.of("first", "second"), done);
  }

  @Test
  void whoeverWaitsHearsWhenEverythingIsWritten() throws Exception {
    CountDownLatch slow = new CountDownLatch(1);
    DispatchThread.run(
        () -> {
          add(FILE, "first", () -> await(slow));
          add(FILE, "second", () -> {});
          queue.whenDone(() -> done.add("all"));
          assertTrue(queue.writes(FILE));
        });
    slow.countDown();
    DispatchThread.await(() -> done.size() == 3);
    assertEquals(List.of("first", "second", "all"), done);
    DispatchThread.run(
        () -> {
          assertFalse(queue.writes(FILE));
          queue.whenDone(() -> done.add("at once"));
        });
    assertEquals("at once", done.getLast());
  }

  @Test
  void theNextSaveIsDoneAfterOneThatHasFailedOrThrown() throws Exception {
    try (ReportedFaults faults = new ReportedFaults()) {
      DispatchThread.run(
          () -> {
            queue.add(
                FILE,
                () ->
                    () -> {
                      throw new IOException("the disk is full");
                    },
                result -> {},
                failed -> done.add(failed.getMessage()));
            queue.add(
                FILE,
                () -> () -> "",
                result -> {
                  throw new IllegalStateException("a fault of who is told");
                },
                failed -> {});
            add(FILE, "last", () -> {});
          });
      DispatchThread.await(() -> done.size() == 2);
      assertEquals(List.of("the disk is full", "last"), done);
      assertEquals(1, faults.all().size());
    }
  }

  private void add(Path file, String name, Runnable work) {
    queue.add(
        file,
        () ->
            () -> {
              work.run();
              return name;
            },
        done::add,
        failed -> done.add("failed"));
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
