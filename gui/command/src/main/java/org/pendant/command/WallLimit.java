package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.OptionalDouble;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Wall clock limit: how long a program may run. A run that does not end when it is asked to is cut
 * off.
 */
final class WallLimit implements AutoCloseable {
  static final Option OPTION =
      Option.of("--wall-timeout", RunOptions.SECONDS)
          .documented(
              "S",
              "stop each program after S seconds on the wall, whatever it does; for CI, which must"
                  + " not hang");

  /** A run that has not ended so long after its limit never will. */
  private static final int PATIENCE_S = 10;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final OptionalDouble limitS;
  private volatile boolean over;

  private WallLimit(OptionalDouble limitS) {
    this.limitS = limitS;
  }

  /**
   * Time begins to count.
   *
   * @param limitS empty for no limit, s
   * @param name of the program, for the message when it has to be cut off
   */
  static WallLimit begin(OptionalDouble limitS, String name) {
    WallLimit limit = new WallLimit(limitS);
    if (limitS.isPresent()) {
      Thread.ofPlatform()
          .daemon()
          .name("wall limit")
          .start(() -> limit.watch(Math.round(limitS.getAsDouble() * 1e9), name));
    }
    return limit;
  }

  private void watch(long limitNs, String name) {
    try {
      if (ended.await(limitNs, TimeUnit.NANOSECONDS)) {
        return;
      }
      over = true;
      if (!ended.await(PATIENCE_S, TimeUnit.SECONDS)) {
        System.err.println(text("cutOff", name, PATIENCE_S));
        Runtime.getRuntime().halt(ExitCode.TIMED_OUT.number());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether the time is over; costs next to nothing. */
  boolean over() {
    return over;
  }

  /** The limit, s; empty for none. */
  OptionalDouble limitS() {
    return limitS;
  }

  /** The run has ended. */
  @Override
  public void close() {
    ended.countDown();
  }
}
