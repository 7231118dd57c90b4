package org.pendant.recording.compare;

import static org.pendant.recording.compare.CompareTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Rotations;
import org.pendant.recording.compare.Difference.Figure;
import org.pendant.recording.compare.Difference.Residual;

/**
 * Comparison of a recording with Pendant's run of the same program: both laid upon one another in
 * time, and what they differ in.
 *
 * @param recorded the recording
 * @param pendant Pendant's run
 * @param shiftS what a time of the recording has to be increased by to be one of Pendant's run, s
 * @param differences figures first
 * @param notes what people should know of it
 */
public record RunComparison(
    Samples recorded,
    Samples pendant,
    double shiftS,
    List<Difference> differences,
    List<String> notes) {
  private static final double MILLI = 1e-3;

  /** Copies the lists. */
  public RunComparison {
    differences = List.copyOf(differences);
    notes = List.copyOf(notes);
  }

  /**
   * Compares.
   *
   * @param recorded has target or actual speeds, see {@link StartOfRun#withSpeeds}
   * @param pendant has all of {@link #needed}
   * @param kinematics of the arm
   * @throws IllegalArgumentException if the recording has no speeds
   */
  public static RunComparison of(Samples recorded, Samples pendant, ForwardKinematics kinematics) {
    StateQuantity speed =
        SampledQuantity.speed(recorded)
            .orElseThrow(() -> new IllegalArgumentException("the recording has no joint speeds"));
    double shiftS = Alignment.shiftS(recorded, pendant, speed);
    List<String> notes = new ArrayList<>();
    List<Difference> all = new ArrayList<>(times(recorded, pendant, shiftS, speed, notes));
    StateQuantity joints =
        recorded.has(SampledQuantity.ACTUAL_Q)
            ? SampledQuantity.ACTUAL_Q
            : SampledQuantity.TARGET_Q;
    TcpPath path = TcpPath.of(recorded, pendant, shiftS, joints, kinematics);
    all.add(figure("path-mean", "mm", 0, path.meanM() / MILLI));
    all.add(figure("path-max", "mm", 0, path.largestM() / MILLI));
    all.addAll(tracking(recorded, pendant, shiftS));
    for (StateQuantity each : SampledQuantity.all()) {
      if (recorded.has(each)) {
        all.addAll(residuals(recorded, pendant, shiftS, each));
      }
    }
    return new RunComparison(recorded, pendant, shiftS, all, notes);
  }

  /** What Pendant's run has to have samples of, to be compared with a recording. */
  public static List<StateQuantity> needed(Samples recorded) {
    Set<StateQuantity> all =
        new LinkedHashSet<>(
            List.of(
                SampledQuantity.TARGET_Q,
                SampledQuantity.TARGET_QD,
                SampledQuantity.ACTUAL_Q,
                SampledQuantity.ACTUAL_QD,
                SampledQuantity.TARGET_CURRENT,
                SampledQuantity.CURRENT,
                SampledQuantity.TCP_OFFSET));
    all.addAll(recorded.quantities());
    return List.copyOf(all);
  }

  private static Figure figure(String name, String unit, double recorded, double pendant) {
    return new Figure(name, unit, recorded, pendant, pendant - recorded);
  }

  /**
   * Duration, and its parts from rest to half the top speed, between the half top speeds, and to
   * rest. When the recording left rest is known between two samples only: inside of these Pendant
   * is not off.
   */
  private static List<Difference> times(
      Samples recorded, Samples pendant, double shiftS, StateQuantity speed, List<String> notes) {
    double top = MotionSpan.topRadPerS(recorded, speed);
    MotionSpan real = new MotionSpan(recorded, speed, top);
    MotionSpan ours = new MotionSpan(pendant, speed, top);
    Optional<Double> realFirst = real.firstHalfS();
    Optional<Double> realLast = real.lastHalfS();
    Optional<Double> ourFirst = ours.firstHalfS();
    Optional<Double> ourLast = ours.lastHalfS();
    List<Difference> figures = new ArrayList<>();
    Optional<Figure> start = Optional.empty();
    if (realFirst.isPresent() && ourFirst.isPresent() && ours.start().isPresent()) {
      start =
          real.start()
              .map(
                  each -> edge("start", each, realFirst.get(), ours.start().get(), ourFirst.get()));
    }
    Optional<Figure> stop = Optional.empty();
    if (realLast.isPresent() && ourLast.isPresent() && ours.stop().isPresent()) {
      stop =
          real.stop()
              .map(each -> edge("stop", each, realLast.get(), ours.stop().get(), ourLast.get()));
    }
    if (start.isPresent() && stop.isPresent()) {
      Figure middle =
          figure(
              "half-duration",
              "s",
              realLast.get() - realFirst.get(),
              ourLast.get() - ourFirst.get());
      double realS = start.get().recorded() + middle.recorded() + stop.get().recorded();
      double oursS = start.get().pendant() + middle.pendant() + stop.get().pendant();
      double error = start.get().error() + middle.error() + stop.get().error();
      figures.add(new Figure("duration", "s", realS, oursS, error));
      figures.add(middle);
    } else {
      notes.add(text(start.isPresent() ? "endsInMotion" : "beginsInMotion"));
    }
    start.ifPresent(figures::add);
    stop.ifPresent(figures::add);
    notes.add(text("timeZero", String.format(Locale.ROOT, "%.4f", recorded.firstS() + shiftS)));
    return figures;
  }

  /** The time between leaving rest, or coming to it, and half the top speed. */
  private static Figure edge(
      String name,
      MotionSpan.Between real,
      double realHalfS,
      MotionSpan.Between ours,
      double ourHalfS) {
    double realS = Math.abs(real.middleS() - realHalfS);
    double oursS = Math.abs(ours.middleS() - ourHalfS);
    double placedS = ours.middleS() - ourHalfS + realHalfS;
    double outside = real.distanceS(placedS);
    return new Figure(name, "s", realS, oursS, real.middleS() < realHalfS ? -outside : outside);
  }

  private static List<Difference> tracking(Samples recorded, Samples pendant, double shiftS) {
    double[] realTimes = new double[recorded.rows()];
    double[] ourTimes = new double[realTimes.length];
    for (int row = 0; row < realTimes.length; row++) {
      realTimes[row] = recorded.timeS(row);
      ourTimes[row] = recorded.timeS(row) + shiftS;
    }
    Tracking real = new Tracking(recorded, realTimes);
    Tracking ours = new Tracking(pendant, ourTimes);
    List<Difference> figures = new ArrayList<>();
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      add("lag_" + joint, "ms", MILLI, real.lagS(joint), ours.lagS(joint), figures);
    }
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      add(
          "speed-error_" + joint,
          "rad/s",
          1,
          real.rms(joint, SampledQuantity.TARGET_QD, SampledQuantity.ACTUAL_QD),
          ours.rms(joint, SampledQuantity.TARGET_QD, SampledQuantity.ACTUAL_QD),
          figures);
    }
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      add(
          "current-error_" + joint,
          "A",
          1,
          real.rms(joint, SampledQuantity.TARGET_CURRENT, SampledQuantity.CURRENT),
          ours.rms(joint, SampledQuantity.TARGET_CURRENT, SampledQuantity.CURRENT),
          figures);
    }
    return figures;
  }

  private static void add(
      String name,
      String unit,
      double unitSi,
      OptionalDouble real,
      OptionalDouble ours,
      List<Difference> figures) {
    if (real.isPresent() && ours.isPresent()) {
      figures.add(figure(name, unit, real.getAsDouble() / unitSi, ours.getAsDouble() / unitSi));
    }
  }

  private static List<Difference> residuals(
      Samples recorded, Samples pendant, double shiftS, StateQuantity quantity) {
    List<Difference> all = new ArrayList<>();
    boolean pose = SampledQuantity.isPose(quantity);
    for (int i = 0; i < (pose ? 3 : quantity.size()); i++) {
      int component = i;
      all.add(
          residual(
              SampledQuantity.name(quantity, i),
              SampledQuantity.unit(quantity, i),
              recorded,
              row -> recorded.value(quantity, component, row),
              row ->
                  pendant.at(quantity, component, recorded.timeS(row) + shiftS)
                      - recorded.value(quantity, component, row)));
    }
    if (pose) {
      all.add(
          residual(
              SampledQuantity.name(quantity) + "_rotation",
              SampledQuantity.unit(quantity, 3),
              recorded,
              row -> 0,
              row -> {
                int near = pendant.rowBefore(recorded.timeS(row) + shiftS);
                return angleRad(recorded.values(quantity, row), pendant.values(quantity, near));
              }));
    }
    return all;
  }

  /** The angle between two orientations, rad. */
  private static double angleRad(double[] one, double[] other) {
    double[] a = new double[9];
    double[] b = new double[9];
    Rotations.vectorToMatrix(one[3], one[4], one[5], a);
    Rotations.vectorToMatrix(other[3], other[4], other[5], b);
    double trace = 0;
    double skew = 0;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double product = 0;
        double turned = 0;
        for (int k = 0; k < 3; k++) {
          product += a[3 * k + i] * b[3 * k + j];
          turned += a[3 * k + j] * b[3 * k + i];
        }
        trace += i == j ? product : 0;
        skew += i < j ? (product - turned) * (product - turned) : 0;
      }
    }
    return Math.atan2(Math.sqrt(skew), trace - 1);
  }

  private interface OfRow {
    double number(int row);
  }

  private static Residual residual(
      String name, String unit, Samples recorded, OfRow value, OfRow error) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    double sum = 0;
    double squares = 0;
    double largest = 0;
    for (int row = 0; row < recorded.rows(); row++) {
      double number = value.number(row);
      double off = error.number(row);
      least = Math.min(least, number);
      most = Math.max(most, number);
      sum += off;
      squares += off * off;
      if (Math.abs(off) > Math.abs(largest)) {
        largest = off;
      }
    }
    int rows = recorded.rows();
    return new Residual(name, unit, least, most, sum / rows, Math.sqrt(squares / rows), largest);
  }

  /**
   * What a limit of this name is compared with: the size of the difference called so, or the
   * largest of those of its joints or axes.
   *
   * @param name such as {@code duration}, {@code target_moment} or {@code target_moment_2}
   * @return empty if there is none
   */
  public OptionalDouble size(String name) {
    return differences.stream()
        .filter(each -> each.name().equals(name) || stem(each.name()).equals(name))
        .mapToDouble(Difference::size)
        .max();
  }

  private static String stem(String name) {
    return name.replaceFirst("_(\\d|rotation)$", "");
  }

  /** The names that limits may have, without those of single joints and axes. */
  public List<String> names() {
    return differences.stream().map(each -> stem(each.name())).distinct().toList();
  }
}
