package org.pendant.command;

import java.util.Locale;
import java.util.concurrent.TimeUnit;

/** Sweep progress: tells now and then how far a sweep is, how fast, and how long it will take. */
final class SweepProgress {
  private static final long EVERY_NS = TimeUnit.SECONDS.toNanos(5);

  private final Console console;
  private final long first;
  private final long size;
  private final long startNs;
  private long toldNs;

  /**
   * @param first how many runs there were before
   * @param size how many there are in all
   * @param nowNs when it begins
   */
  SweepProgress(Console console, long first, long size, long nowNs) {
    this.console = console;
    this.first = first;
    this.size = size;
    startNs = nowNs;
    toldNs = nowNs;
  }

  /** So many runs have a row. */
  void at(long done, long nowNs) {
    if (nowNs - toldNs >= EVERY_NS && done > first) {
      toldNs = nowNs;
      double seconds = (nowNs - startNs) * 1e-9;
      double perS = (done - first) / seconds;
      console.complain(
          String.format(
              Locale.ROOT,
              "%d of %d runs, %.0f a minute, %s left",
              done,
              size,
              perS * 60,
              duration(Math.round((size - done) / perS))));
    }
  }

  /** The last words. */
  void end(long done, long nowNs) {
    double seconds = (nowNs - startNs) * 1e-9;
    console.complain(
        String.format(
            Locale.ROOT,
            "%d of %d runs, %d of them now in %s, %.0f a minute",
            done,
            size,
            done - first,
            duration(Math.round(seconds)),
            seconds > 0 ? (done - first) / seconds * 60 : 0));
  }

  /** A duration for people, such as {@code 2 min 5 s}. */
  static String duration(long seconds) {
    if (seconds < 60) {
      return seconds + " s";
    }
    if (seconds < 3600) {
      return seconds / 60 + " min " + seconds % 60 + " s";
    }
    return seconds / 3600 + " h " + seconds % 3600 / 60 + " min";
  }
}
