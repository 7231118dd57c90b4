package org.pendant.client;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** A process and the lines that it writes, to either stream. */
final class Talker implements AutoCloseable {
  private static final int MAX_LINES = 5_000;

  private final Process process;
  private final List<String> lines = new ArrayList<>();
  private boolean silent;

  private Talker(Process process) {
    this.process = process;
  }

  static Talker start(ProcessBuilder builder) {
    try {
      Process process = builder.redirectErrorStream(true).start();
      process.getOutputStream().close();
      Talker talker = new Talker(process);
      Thread.ofPlatform().daemon().name("reads " + process.pid()).start(talker::listen);
      return talker;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void listen() {
    try (BufferedReader reader = process.inputReader(StandardCharsets.UTF_8)) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        heard(line);
      }
    } catch (IOException e) {
      heard("(the rest cannot be read: " + e.getMessage() + ")");
    } finally {
      fallSilent();
    }
  }

  private synchronized void heard(String line) {
    if (lines.size() < MAX_LINES) {
      lines.add(line);
    }
    notifyAll();
  }

  private synchronized void fallSilent() {
    silent = true;
    notifyAll();
  }

  /** Waits for a line; empty when there is none in time or the process has ended. */
  synchronized Optional<String> awaitLine(Predicate<String> wanted, long timeS) {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(timeS);
    try {
      for (int next = 0; ; ) {
        for (; next < lines.size(); next++) {
          if (wanted.test(lines.get(next))) {
            return Optional.of(lines.get(next));
          }
        }
        long leftMs = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        if (silent || leftMs <= 0) {
          return Optional.empty();
        }
        wait(leftMs);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }

  /** All lines so far. */
  synchronized String said() {
    return String.join("\n", lines);
  }

  /** Waits for the end; its exit code, or nothing when it continues. */
  OptionalInt awaitEnd(long timeS) {
    try {
      return process.waitFor(timeS, TimeUnit.SECONDS)
          ? OptionalInt.of(process.exitValue())
          : OptionalInt.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return OptionalInt.empty();
    }
  }

  /** Asks the process to end. */
  void terminate() {
    process.destroy();
  }

  /** Its number. */
  long pid() {
    return process.pid();
  }

  /** Ends the process if it has not ended. */
  @Override
  public void close() {
    process.destroyForcibly();
  }
}
