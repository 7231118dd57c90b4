package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

import java.awt.Color;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.pendant.kit.theme.Palette;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.text.Language;

/** Words about runs of a sweep, and the colours that go with them. */
final class SweepWords {
  private static final int MINUTE_S = 60;
  private static final int HOUR_S = 3600;

  private SweepWords() {}

  /** A number in few digits; empty for none. */
  static String brief(double number) {
    if (Double.isNaN(number)) {
      return "";
    }
    if (number == Math.rint(number) && Math.abs(number) < 1e9) {
      return Long.toString((long) number);
    }
    double size = Math.abs(number);
    return size >= 1e6 || size < 1e-4
        ? String.format(Locale.ROOT, "%.3e", number)
        : String.format(Locale.ROOT, "%.4f", number).replaceFirst("0{1,3}$", "");
  }

  /** The colour of an outcome. */
  static Color color(Optional<RunOutcome> outcome) {
    return outcome
        .map(
            each ->
                switch (each) {
                  case FINISHED, HALTED -> Palette.ok();
                  case STOPPED, NEVER_ENDED -> Palette.warning();
                  case FAILED, DOES_NOT_COMPILE, REFUSED, INTERNAL_ERROR -> Palette.error();
                })
        .orElseGet(Palette::quiet);
  }

  /** How many runs ended in which way. */
  static String outcomes(Map<String, Integer> counts) {
    return counts.entrySet().stream()
        .map(each -> text("outcomeCount", each.getValue(), outcome(each.getKey())))
        .reduce((first, next) -> text("outcomesListed", first, next))
        .orElse("");
  }

  /** An outcome, which tables of results write as a word. */
  static String outcome(String word) {
    return RunOutcome.of(word).map(each -> text(key(each))).orElse(word);
  }

  private static String key(RunOutcome outcome) {
    return switch (outcome) {
      case FINISHED -> "outcomeFinished";
      case HALTED -> "outcomeHalted";
      case FAILED -> "outcomeFailed";
      case STOPPED -> "outcomeStopped";
      case NEVER_ENDED -> "outcomeNeverEnded";
      case DOES_NOT_COMPILE -> "outcomeDoesNotCompile";
      case REFUSED -> "outcomeRefused";
      case INTERNAL_ERROR -> "outcomeInternalError";
    };
  }

  /**
   * How many runs a plan has.
   *
   * @param search whether it may end before it has run them all
   */
  static String runs(long count, boolean search) {
    if (search) {
      return text(count == 1 ? "atMostOneRun" : "atMostRuns", count(count));
    }
    return text(count == 1 ? "oneRunInPlan" : "runsInPlan", count(count));
  }

  /** How far a sweep is. */
  static String progress(RunningSweep sweep) {
    if (sweep.size() == 0) {
      return sweep.ended() ? text("notStarted") : text("readingThePlan");
    }
    return progress(sweep.done(), sweep.size(), sweep.perS(), sweep.ended());
  }

  /**
   * How far a sweep is.
   *
   * @param perS runs in a second; 0 while it is not known
   */
  static String progress(long doneRuns, long runs, double perS, boolean ended) {
    String done = text("done", count(doneRuns), count(runs));

    if (perS <= 0) {
      return done;
    }
    String aMinute = count(Math.round(perS * MINUTE_S));
    return ended
        ? text("doneWithRate", done, aMinute)
        : text(
            "doneWithRateAndRest", done, aMinute, duration(Math.round((runs - doneRuns) / perS)));
  }

  private static String count(long runs) {
    return Language.ofProcess().grouped(runs);
  }

  /** A duration, such as {@code 2 min 5 s}. */
  static String duration(long seconds) {
    if (seconds < MINUTE_S) {
      return text("seconds", seconds);
    }
    return seconds < HOUR_S
        ? text("minutesSeconds", seconds / MINUTE_S, seconds % MINUTE_S)
        : text("hoursMinutes", seconds / HOUR_S, seconds % HOUR_S / MINUTE_S);
  }
}
