package org.pendant.desktop.whatif;

import static org.pendant.desktop.whatif.WhatIfTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntFunction;
import org.pendant.kit.text.Messages;
import org.pendant.recording.whatif.Peak;
import org.pendant.recording.whatif.VariantOutcome;

/** Result words: what came of variants, as it stands in the panel. */
final class ResultWords {
  /** A smaller difference is none. */
  private static final double SAME = 1e-9;

  private static final double PERCENT = 100;

  /** From here on no digits are shown behind the point of a difference. */
  private static final double TENS = 9.95;

  private ResultWords() {}

  /** A number that variants are compared by; the less the better. */
  enum Figure {
    CYCLE(text("cycle")),
    TORQUE(text("peakTorque")),
    JOINT_SPEED(text("peakSpeed")),
    ENERGY(text("energy"));

    private final String title;

    Figure(String title) {
      this.title = title;
    }

    String title() {
      return title;
    }

    OptionalDouble of(VariantOutcome outcome) {
      return switch (this) {
        case CYCLE -> outcome.cycleS();
        case TORQUE -> share(outcome.torque());
        case JOINT_SPEED -> share(outcome.jointSpeed());
        case ENERGY -> OptionalDouble.of(outcome.energyJ() * part(outcome));
      };
    }

    /** How much of the energy is meant: that of one round of a program that never ends. */
    private static double part(VariantOutcome outcome) {
      return outcome.roundOf() > 0 && outcome.timeS() > 0
          ? outcome.cycleS().orElse(0) / outcome.timeS()
          : 1;
    }

    private static OptionalDouble share(Optional<Peak> peak) {
      return peak.isPresent() ? OptionalDouble.of(peak.get().share()) : OptionalDouble.empty();
    }
  }

  /** How far a variant has come, or how it ended. */
  static String state(VariantResult result) {
    return switch (result) {
      case VariantResult.None _ -> "";
      case VariantResult.Waiting _ -> text("waits");
      case VariantResult.Running(var run) ->
          run.reachedS() > 0
              ? String.format(Locale.ROOT, text("reached"), run.reachedS())
              : String.format(Locale.ROOT, text("repeats"), PERCENT * run.repeated());
      case VariantResult.Done(var outcome) -> capital(Messages.shown(outcome.words()));
      case VariantResult.Refused(String reason) -> Messages.shown(reason);
    };
  }

  private static String capital(String words) {
    return words.isEmpty()
        ? ""
        : words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
  }

  /** Whether something went wrong with a variant. */
  static boolean wrong(VariantResult result) {
    return switch (result) {
      case VariantResult.None _, VariantResult.Waiting _, VariantResult.Running _ -> false;
      case VariantResult.Refused _ -> true;
      case VariantResult.Done(var outcome) -> !whole(outcome);
    };
  }

  /** Whether it ran as far as it was to. */
  private static boolean whole(VariantOutcome outcome) {
    return outcome.end() == VariantOutcome.End.FINISHED
        || outcome.end() == VariantOutcome.End.LIMIT;
  }

  /**
   * A figure, and the difference to the first variant.
   *
   * @param first empty for the first variant itself, and where nothing has come of it
   */
  static String figure(Figure figure, VariantOutcome outcome, Optional<VariantOutcome> first) {
    OptionalDouble value = figure.of(outcome);
    if (value.isEmpty()) {
      return "\u2013";
    }
    OptionalDouble than = first.map(figure::of).orElse(OptionalDouble.empty());
    String text =
        switch (figure) {
          case CYCLE -> ofRound(String.format(Locale.ROOT, "%.3f s", value.getAsDouble()), outcome);
          case TORQUE, JOINT_SPEED ->
              String.format(Locale.ROOT, "%.1f %%", PERCENT * value.getAsDouble());
          case ENERGY ->
              ofRound(String.format(Locale.ROOT, "%.0f J", value.getAsDouble()), outcome);
        };
    return than.isEmpty()
        ? text
        : text + difference(figure, value.getAsDouble(), than.getAsDouble());
  }

  private static String difference(Figure figure, double value, double than) {
    double by =
        switch (figure) {
          case CYCLE, ENERGY -> than == 0 ? 0 : PERCENT * (value / than - 1);
          case TORQUE, JOINT_SPEED -> PERCENT * (value - than);
        };
    String number =
        String.format(Locale.ROOT, Math.abs(by) < TENS ? "%+.1f" : "%+.0f", by)
            .replace('-', '\u2212');
    boolean none = number.endsWith("0.0") && number.length() == "+0.0".length();
    String unit =
        switch (figure) {
          case CYCLE, ENERGY -> " %";
          case TORQUE, JOINT_SPEED -> "";
        };
    return none ? " (=)" : " (" + number + unit + ")";
  }

  /** Whether a variant is the best of those that ran through, and another one is worse. */
  static boolean best(Figure figure, int row, List<VariantResult> results) {
    Optional<VariantOutcome> own = results.get(row).finished().filter(ResultWords::whole);
    OptionalDouble value = own.map(figure::of).orElse(OptionalDouble.empty());
    if (value.isEmpty()) {
      return false;
    }
    double[] all =
        results.stream()
            .flatMap(each -> each.finished().filter(ResultWords::whole).stream())
            .map(figure::of)
            .filter(OptionalDouble::isPresent)
            .mapToDouble(OptionalDouble::getAsDouble)
            .toArray();
    double least = value.getAsDouble();
    boolean worse = false;
    for (double each : all) {
      if (each < least - SAME) {
        return false;
      }
      worse |= each > least + SAME;
    }
    return worse;
  }

  /**
   * All that is known of a figure.
   *
   * @param places what a line is called in a sentence
   */
  static String about(Figure figure, VariantOutcome outcome, IntFunction<String> places) {
    return switch (figure) {
      case CYCLE ->
          outcome.cycleS().isEmpty()
              ? String.format(Locale.ROOT, text("notFinishedStoppedSAfterThe"), outcome.timeS())
              : outcome.roundOf() > 0
                  ? text("fromOneTimeThatPlaceIs", places.apply(outcome.roundOf()))
                  : String.format(Locale.ROOT, text("fromTheStartOfTheProgram"), outcome.timeS());
      case TORQUE -> outcome.torque().map(each -> peak(each, places)).orElse("");
      case JOINT_SPEED -> outcome.jointSpeed().map(each -> peak(each, places)).orElse("");
      case ENERGY -> String.format(Locale.ROOT, text("whatTheArmTookFromIts"), outcome.timeS());
    };
  }

  private static String ofRound(String amount, VariantOutcome outcome) {
    return outcome.roundOf() > 0 ? text("aRound", amount) : amount;
  }

  private static String peak(Peak peak, IntFunction<String> places) {
    return String.format(
        Locale.ROOT,
        text("peakPlace"),
        capital(peak.joint()),
        places.apply(peak.line()),
        peak.timeS());
  }
}
