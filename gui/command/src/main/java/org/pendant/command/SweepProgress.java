package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.pendant.sweep.SweepListener;
import org.pendant.sweep.run.SweepResult;

/** Sweep progress: tells now and then how far a sweep is, how fast, and how long it will take. */
final class SweepProgress implements SweepListener {
  private static final long EVERY_NS = TimeUnit.SECONDS.toNanos(5);

  private final Console console;
  private final String where;
  private final Interruption interruption;
  private long first;
  private long size;
  private long startNs;
  private long toldNs;

  /**
   * @param where the runs are run
   * @param interruption is held from the first run on: what is there then is told at the end
   */
  SweepProgress(Console console, String where, Interruption interruption) {
    this.console = console;
    this.where = where;
    this.interruption = interruption;
  }

  @Override
  public void begin(long done, long all) {
    console.complain(text("runsBy", all, where));
    interruption.hold();
    first = done;
    size = all;
    startNs = System.nanoTime();
    toldNs = startNs;
  }

  @Override
  public void take(SweepResult result, List<Optional<Object>> row) {
    at(result.variant().number() + 1, System.nanoTime());
  }

  /** So many runs have a row. */
  private void at(long done, long nowNs) {
    if (nowNs - toldNs >= EVERY_NS && done > first) {
      toldNs = nowNs;
      double seconds = (nowNs - startNs) * 1e-9;
      double perS = (done - first) / seconds;
      console.complain(
          String.format(
              Locale.ROOT,
              text("runsLeft"),
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
            text("runsDone"),
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
