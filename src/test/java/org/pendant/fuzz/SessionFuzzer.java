package org.pendant.fuzz;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.pendant.protocols.net.TcpPort;

/**
 * Has random clients speak to all ports of one box, some at once, and looks after every few whether
 * the box still answers everywhere and has nothing left of them. The same seed makes the same
 * clients; what they meet is up to the machine.
 */
public final class SessionFuzzer implements AutoCloseable {
  private static final int AT_ONCE = 12;
  private static final int PATIENCE_S = 120;

  private final long seed;
  private final FuzzedBox box;
  private final ThreadPoolExecutor clients =
      new ThreadPoolExecutor(AT_ONCE, AT_ONCE, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>());
  private int done;

  /**
   * With a box of its own.
   *
   * @param folder for what the box writes
   */
  SessionFuzzer(long seed, Path folder) {
    this.seed = seed;
    box = new FuzzedBox(folder);
  }

  /** {@code sessions [seed]}: runs so many, and says what it found. */
  public static void main(String[] arguments) throws Exception {
    int sessions = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 60_000;
    long seed = arguments.length > 1 ? Long.parseLong(arguments[1]) : System.nanoTime();
    System.out.println("seed " + seed);
    Path folder = Files.createTempDirectory("pendant-fuzz");
    try (SessionFuzzer fuzzer = new SessionFuzzer(seed, folder)) {
      long beganNs = System.nanoTime();
      for (int next = 1000; fuzzer.done < sessions; next += 1000) {
        Optional<String> found = fuzzer.run(Math.min(next, sessions) - fuzzer.done);
        if (found.isPresent()) {
          System.out.println(found.get());
          System.exit(1);
        }
        System.out.println(
            fuzzer.done
                + " sessions, "
                + TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - beganNs)
                + " s, "
                + usedMegabytes()
                + " MB");
      }
    }
  }

  private static long usedMegabytes() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return (runtime.totalMemory() - runtime.freeMemory()) >> 20;
  }

  /**
   * Runs so many sessions.
   *
   * @return what is wrong, with all that is needed to see it again; empty if nothing is
   */
  Optional<String> run(int sessions) throws InterruptedException {
    int end = done + sessions;
    if (done == 0) {
      // the first ones load classes and start threads
      warmUp();
    }
    while (done < end) {
      List<Future<String>> running = new ArrayList<>();
      for (int i = 0; i < AT_ONCE && done < end; i++) {
        running.add(clients.submit(session(done++)));
      }
      for (Future<String> each : running) {
        Optional<String> wrong = outcome(each);
        if (wrong.isPresent()) {
          return wrong;
        }
      }
      Optional<String> wrong = box.complaint();
      if (wrong.isPresent()) {
        return Optional.of(wrong.get() + after());
      }
    }
    return Optional.empty();
  }

  private void warmUp() throws InterruptedException {
    clients.prestartAllCoreThreads();
    var _ = box.complaint();
    box.remember();
  }

  private String after() {
    return ", after session " + done + " of seed " + seed;
  }

  private Callable<String> session(int number) {
    TcpPort port = box.ports().get(number % box.ports().size());
    RandomSession session =
        new RandomSession(
            InetAddress.getLoopbackAddress(),
            port.number(),
            Vocabulary.of(port.name()),
            seed + number);
    return () -> {
      try {
        session.run();
        return "";
      } catch (IOException e) {
        return port.name() + ", session " + number + " (" + session.description() + "): " + e;
      }
    };
  }

  private Optional<String> outcome(Future<String> session) throws InterruptedException {
    try {
      String wrong = session.get(PATIENCE_S, TimeUnit.SECONDS);
      return wrong.isEmpty() ? Optional.empty() : Optional.of(wrong + after());
    } catch (ExecutionException e) {
      return Optional.of("a session failed: " + e.getCause() + after());
    } catch (TimeoutException e) {
      return Optional.of("a session does not end" + after());
    }
  }

  @Override
  public void close() {
    clients.shutdownNow();
    box.close();
  }
}
