package org.pendant.recording.compare;

import static org.pendant.recording.compare.CompareTexts.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.compare.RunTrack.Sample;
import org.pendant.recording.compare.RunTrack.Switch;
import org.pendant.recording.compare.RunTrack.Text;

/**
 * Comparison of a run with an earlier one, both from the switch-on, within bands: the arm has to
 * have been nearby at nearly the same time, in both directions; each output changes as often and
 * nearly then; the same lines of text; nearly as long.
 */
public final class TrackComparison {
  private static final double MM_PER_M = 1000;

  /** So many before and after: more would hide a small difference of an arm that moves. */
  private static final long CURVE_FRAMES = FrameTime.FRAMES_PER_SECOND / 4;

  private final RunTrack now;
  private final RunTrack before;
  private final TrackTolerance tolerance;
  private final long band;
  private final List<Found> found = new ArrayList<>();

  /** A quantity that has a curve. */
  private record Curve(String what, String unit, ToDoubleBiFunction<RunTrack, Long> of) {}

  /** A first difference of one kind. */
  private record Found(TrackDifference difference, Optional<Curve> curve) {}

  private TrackComparison(RunTrack now, RunTrack before, TrackTolerance tolerance) {
    this.now = now;
    this.before = before;
    this.tolerance = tolerance;
    band = tolerance.frames();
  }

  /**
   * The first difference; empty where the run did the same.
   *
   * @param before the earlier one
   */
  public static Optional<TrackDifference> first(
      RunTrack now, RunTrack before, TrackTolerance tolerance) {
    TrackComparison comparison = new TrackComparison(now, before, tolerance);
    comparison.arm();
    comparison.outputs();
    comparison.texts();
    comparison.duration();
    return comparison.found.stream()
        .min(Comparator.comparingLong(each -> each.difference().frame()))
        .map(comparison::withCurves);
  }

  private TrackDifference withCurves(Found first) {
    TrackDifference bare = first.difference();
    return new TrackDifference(
        bare.frame(),
        bare.line(),
        bare.words(),
        first
            .curve()
            .map(
                curve ->
                    new TrackCurves(
                        curve.what(),
                        curve.unit(),
                        timeS(bare.frame()),
                        points(now, curve, bare.frame()),
                        points(before, curve, bare.frame()))));
  }

  private static List<TrackCurves.Point> points(RunTrack track, Curve curve, long around) {
    List<TrackCurves.Point> points = new ArrayList<>();
    long last = Math.min(around + CURVE_FRAMES, track.lastFrame());
    for (long frame = Math.max(0, around - CURVE_FRAMES); frame <= last; frame++) {
      points.add(new TrackCurves.Point(timeS(frame), curve.of().applyAsDouble(track, frame)));
    }
    return points;
  }

  private void add(long frame, Optional<Curve> curve, String words) {
    long last = Math.min(frame, now.lastFrame());
    found.add(
        new Found(new TrackDifference(frame, now.at(last).line(), words, Optional.empty()), curve));
  }

  private static double timeS(long frame) {
    return frame * FrameTime.FRAME_S;
  }

  private void arm() {
    tolerance
        .deg()
        .ifPresent(
            deg ->
                firstApart(
                        (one, other) -> one.target().maxAbsDifference(other.target()),
                        Math.toRadians(deg + before.within().deg()))
                    .ifPresent(frame -> addJoint(frame, deg)));
    tolerance
        .mm()
        .ifPresent(
            mm ->
                firstApart(TrackComparison::tcpMm, mm + before.within().mm())
                    .ifPresent(frame -> addTcp(frame, mm)));
  }

  private static double tcpMm(Sample one, Sample other) {
    Pose a = one.tcp().orElse(Pose.ZERO);
    Pose b = other.tcp().orElse(Pose.ZERO);
    return Math.hypot(Math.hypot(a.x() - b.x(), a.y() - b.y()), a.z() - b.z()) * MM_PER_M;
  }

  /** The first frame in which one run is where the other one was at no time nearby. */
  private Optional<Long> firstApart(ToDoubleBiFunction<Sample, Sample> distance, double most) {
    long last = Math.min(now.lastFrame(), before.lastFrame());
    Search ofNow = new Search(before, distance, most);
    Search ofBefore = new Search(now, distance, most);
    for (long frame = 0; frame <= last; frame++) {
      if (!ofNow.finds(now.at(frame), frame) || !ofBefore.finds(before.at(frame), frame)) {
        return Optional.of(frame);
      }
    }
    return Optional.empty();
  }

  /** Search for places of one run in the other one, a little earlier or later. */
  private final class Search {
    private final RunTrack where;
    private final ToDoubleBiFunction<Sample, Sample> distance;
    private final double most;

    /** How much later the last place was found: the next one probably is as well. */
    private long later;

    private Search(RunTrack where, ToDoubleBiFunction<Sample, Sample> distance, double most) {
      this.where = where;
      this.distance = distance;
      this.most = most;
    }

    private boolean finds(Sample sample, long frame) {
      if (near(sample, frame) || near(sample, frame + later)) {
        return true;
      }
      for (long i = 1; i <= band; i++) {
        for (long each : new long[] {i, -i}) {
          if (near(sample, frame + each)) {
            later = each;
            return true;
          }
        }
      }
      return false;
    }

    /** Never where a number is none. */
    private boolean near(Sample sample, long frame) {
      return distance.applyAsDouble(sample, where.at(frame)) <= most;
    }
  }

  private void addJoint(long frame, double deg) {
    Joints one = now.at(frame).target();
    Joints other = before.at(frame).target();
    int joint = 0;
    for (int i = 1; i < Joints.COUNT; i++) {
      if (Math.abs(one.get(i) - other.get(i)) > Math.abs(one.get(joint) - other.get(joint))) {
        joint = i;
      }
    }
    int most = joint;
    Curve curve =
        new Curve(
            text("joint", most),
            "\u00b0",
            (track, at) -> Math.toDegrees(track.at(at).target().get(most)));
    add(
        frame,
        Optional.of(curve),
        text(
            "jointApart",
            seconds(frame),
            joint,
            decimals(3, Math.toDegrees(one.get(joint))),
            decimals(3, Math.toDegrees(other.get(joint))),
            plain(deg),
            plain(tolerance.seconds())));
  }

  private void addTcp(long frame, double mm) {
    Sample one = now.at(frame);
    Sample other = before.at(frame);
    add(
        frame,
        Optional.of(curveOfTcp(one, other)),
        text(
            "tcpApart",
            seconds(frame),
            place(one),
            place(other),
            decimals(2, tcpMm(one, other)),
            plain(mm),
            plain(tolerance.seconds())));
  }

  /** The coordinate that differs most. */
  private static Curve curveOfTcp(Sample one, Sample other) {
    List<ToDoubleFunction<Pose>> axes = List.of(Pose::x, Pose::y, Pose::z);
    int axis = 0;
    for (int i = 1; i < axes.size(); i++) {
      if (apart(axes.get(i), one, other) > apart(axes.get(axis), one, other)) {
        axis = i;
      }
    }
    ToDoubleFunction<Pose> most = axes.get(axis);
    return new Curve(
        "TCP, " + "xyz".charAt(axis),
        "mm",
        (track, at) -> most.applyAsDouble(track.at(at).tcp().orElse(Pose.ZERO)) * MM_PER_M);
  }

  private static double apart(ToDoubleFunction<Pose> axis, Sample one, Sample other) {
    return Math.abs(
        axis.applyAsDouble(one.tcp().orElse(Pose.ZERO))
            - axis.applyAsDouble(other.tcp().orElse(Pose.ZERO)));
  }

  private static String place(Sample sample) {
    Pose pose = sample.tcp().orElse(Pose.ZERO);
    return String.format(
        Locale.ROOT,
        "[%.2f, %.2f, %.2f]",
        pose.x() * MM_PER_M,
        pose.y() * MM_PER_M,
        pose.z() * MM_PER_M);
  }

  /** As people write it. */
  private static String plain(double number) {
    String text = Double.toString(number);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }

  private void outputs() {
    for (SignalBank bank : SignalBank.values()) {
      for (int i = 0; !bank.input() && bank != SignalBank.FLAG && i < bank.size(); i++) {
        output(new Signal(bank, i));
      }
    }
  }

  private void output(Signal signal) {
    List<Switch> ours = now.switchesOf(signal);
    List<Switch> theirs = before.switchesOf(signal);
    Optional<Curve> curve =
        Optional.of(
            new Curve(signal.toString(), "", (track, at) -> track.level(signal, at) ? 1.0 : 0.0));
    for (int i = 0; i < Math.max(ours.size(), theirs.size()); i++) {
      if (i >= theirs.size()) {
        Switch one = ours.get(i);
        add(
            one.frame(),
            curve,
            text(one.on() ? "goesOn" : "goesOff", seconds(one.frame()), signal));
        return;
      }
      Switch other = theirs.get(i);
      if (i >= ours.size()) {
        add(
            other.frame(),
            curve,
            text(other.on() ? "doesNotGoOn" : "doesNotGoOff", seconds(other.frame()), signal));
        return;
      }
      Switch one = ours.get(i);
      if (Math.abs(one.frame() - other.frame()) > band) {
        add(
            Math.min(one.frame(), other.frame()),
            curve,
            text(
                one.on() ? "goesOnAt" : "goesOffAt",
                signal,
                seconds(one.frame()),
                seconds(other.frame()),
                plain(tolerance.seconds())));
        return;
      }
    }
  }

  private static String seconds(long frame) {
    return decimals(3, timeS(frame));
  }

  private static String decimals(int count, double number) {
    return String.format(Locale.ROOT, "%." + count + "f", number);
  }

  private void texts() {
    List<Text> ours = now.texts();
    List<Text> theirs = before.texts();
    for (int i = 0; i < Math.max(ours.size(), theirs.size()); i++) {
      String one = i < ours.size() ? quoted(ours.get(i)) : text("nothingMore");
      String other = i < theirs.size() ? quoted(theirs.get(i)) : text("nothingMore");
      if (!one.equals(other)) {
        long frame = (i < ours.size() ? ours : theirs).get(i).frame();
        add(frame, Optional.empty(), text("logSays", seconds(frame), one, other));
        return;
      }
    }
  }

  private static String quoted(Text text) {
    return '"' + ByteText.decoded(text.text()) + '"';
  }

  private void duration() {
    if (Math.abs(now.lastFrame() - before.lastFrame()) > band) {
      add(
          Math.min(now.lastFrame(), before.lastFrame()),
          Optional.empty(),
          text(
              "testTakes",
              seconds(now.lastFrame()),
              seconds(before.lastFrame()),
              plain(tolerance.seconds())));
    }
  }
}
