package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.world.LinkHit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.SentenceUnits;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.Measure;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.recording.Column;
import org.pendant.recording.ColumnTrace;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingMark;
import org.pendant.script.function.ScriptPlace;

/**
 * Tracks: what a timeline draws of a stretch of a recording.
 *
 * @param range the stretch
 * @param runs programs, also those that reach out of the stretch
 * @param pauses where a program was paused
 * @param startRamps where the start of a program made its moves slower
 * @param marks of the whole recording, in the order of time
 * @param warnings of the log
 * @param inputs where a digital input changed
 * @param outputs where a digital output changed
 * @param nearestM how far a link of the arm was from another one or an object; empty where nobody
 *     knows
 * @param objectM how far one was from an object or another arm; empty where there was none
 * @param hits what the arm has run into
 * @param speedMPerS how fast the TCP went
 */
record Tracks(
    TimeRange range,
    List<Run> runs,
    List<Bar> pauses,
    List<Bar> startRamps,
    List<RecordingMark> marks,
    List<Warning> warnings,
    List<Bar> inputs,
    List<Bar> outputs,
    Optional<ColumnTrace> nearestM,
    Optional<ColumnTrace> objectM,
    List<Hit> hits,
    Optional<ColumnTrace> speedMPerS) {
  /** Nothing was looked at yet. */
  static final Tracks NONE =
      new Tracks(
          new TimeRange(0, 1),
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          List.of(),
          Optional.empty(),
          Optional.empty(),
          List.of(),
          Optional.empty());

  /** More cannot be told from each other. */
  private static final int MAX_WARNINGS = 2000;

  private static final double PAUSED = 2;

  /** In the text of a stop. */
  private static final Pattern HIT =
      Pattern.compile("(" + LinkHit.THE + "[^:]+" + LinkHit.HAS_HIT + ".+?)(?:: |$)");

  /** A stretch of time, s. */
  record Bar(double fromS, double toS) {}

  /**
   * A collision of the arm.
   *
   * @param words who has hit what
   */
  record Hit(double timeS, String words) {}

  /**
   * A warning of the log.
   *
   * @param line of the program; 0 for none
   */
  record Warning(double timeS, String words, int line) {}

  /** A program from its start to its end. */
  record Run(double fromS, double toS, String name, boolean failed) {
    Run endedBy(double timeS) {
      return new Run(fromS, Math.min(toS, timeS), name, failed);
    }
  }

  /**
   * Looks at a stretch; too slow for the dispatch thread.
   *
   * @param buckets how finely, such as one for each pixel
   * @param startRamp whether the programs of the recording have a start ramp
   * @param cell whether there is something around the arm
   */
  static Tracks of(
      Recording recording, TimeRange range, int buckets, boolean startRamp, boolean cell) {
    List<RecordingMark> marks = recording.marks();
    double fromS = range.fromS();
    double toS = range.toS();
    List<Run> runs = runs(marks, recording.firstS(), recording.lastS(), startedBefore(recording));
    return new Tracks(
        range,
        runs,
        pauses(recording.scan(Column.programState(), fromS, toS, buckets)),
        startRamp ? StartRamps.of(recording, runs, range, buckets) : List.of(),
        marks,
        warnings(recording, fromS, toS),
        edges(recording, range, buckets, true),
        edges(recording, range, buckets, false),
        cell ? distance("link_distance", recording, range, buckets) : Optional.empty(),
        cell ? distance("object_distance", recording, range, buckets) : Optional.empty(),
        hits(marks),
        Optional.of(recording.scan(Column.of("tcp_speed", 0), fromS, toS, buckets)));
  }

  private static Optional<ColumnTrace> distance(
      String quantity, Recording recording, TimeRange range, int buckets) {
    ColumnTrace distance =
        recording.scan(Column.of(quantity, 0), range.fromS(), range.toS(), buckets);
    return IntStream.range(0, distance.size()).allMatch(i -> Double.isNaN(distance.lowest(i)))
        ? Optional.empty()
        : Optional.of(distance);
  }

  /** What stops tell of them. */
  static List<Hit> hits(List<RecordingMark> marks) {
    List<Hit> hits = new ArrayList<>();
    for (RecordingMark mark : marks) {
      Matcher sentence = HIT.matcher(ByteText.decoded(mark.text()));
      if (mark.kind() == RecordingMark.Kind.PROTECTIVE_STOP && sentence.find()) {
        hits.add(new Hit(mark.timeS(), Messages.shown(sentence.group(1))));
      }
    }
    return hits;
  }

  /** With how near something was at a time, such as {@code 3.000 s, nearest 34 mm}. */
  private String withNearest(String about, double timeS, PoseForm form) {
    if (nearestM.isEmpty()) {
      return about;
    }
    ColumnTrace trace = nearestM.get();
    int i = (int) Math.floor(range.share(timeS) * trace.size());
    if (i < 0 || i >= trace.size() || Double.isNaN(trace.lowest(i))) {
      return about;
    }
    double leastM = trace.lowest(i);
    if (leastM < 0) {
      return text("insideOfSomething", about, length(-leastM, 1, form));
    }
    double objectM = this.objectM.map(objects -> objects.lowest(i)).orElse(Double.NaN);
    String least = length(leastM, 0, form);
    String object = length(objectM, 0, form);
    return Double.isNaN(objectM) || object.equals(least)
        ? text("nearestAt", about, least)
        : text("nearestAndLinks", about, object, least);
  }

  /** A distance as exact as so many decimals of a millimetre. */
  private static String length(double lengthM, int decimals, PoseForm form) {
    Measure measure = ShownMeasure.of(Measure.MILLIMETRE, form);
    int more = (int) Math.ceil(Math.log10(Measure.MILLIMETRE.shown(1) / measure.shown(1)));
    return String.format(
        Locale.ROOT, "%." + (decimals + more) + "f %s", measure.shown(lengthM), measure.symbol());
  }

  /** What there is at a time, in words, with numbers in the units of {@code form}. */
  String about(double timeS, double nearS, MomentPlaces places, PoseForm form) {
    String about = LookBack.text(timeS);
    for (RecordingMark mark : marks) {
      if (Math.abs(mark.timeS() - timeS) <= nearS) {
        return text(
            "markAt",
            LookBack.text(mark.timeS()),
            at(SentenceUnits.in(words(mark), form), mark.timeS(), mark.line(), places));
      }
    }
    for (Warning warning : warnings) {
      if (Math.abs(warning.timeS - timeS) <= nearS) {
        return text(
            "warningAt",
            LookBack.text(warning.timeS),
            at(SentenceUnits.in(warning.words, form), warning.timeS, warning.line, places));
      }
    }
    for (Run run : runs) {
      if (run.fromS <= timeS && timeS <= run.toS) {
        about = text("programRuns", about, run.name);
      }
    }
    for (Bar ramp : startRamps) {
      if (ramp.fromS <= timeS && timeS <= ramp.toS) {
        about = text("startRamp", about);
      }
    }
    return withNearest(about, timeS, form);
  }

  private static String words(RecordingMark mark) {
    String text = ByteText.decoded(mark.text());
    return switch (mark.kind()) {
      case PROGRAM_STARTED -> text("programStarts", text);
      case PROGRAM_ENDED -> text("programEnds", text);
      case PROGRAM_FAILED -> text("theProgramFails", text);
      case LABEL -> text;
      case PROTECTIVE_STOP, SAFETY_STOP, ERROR -> Messages.shown(text);
      case MESSAGE -> text("messageMark", text);
    };
  }

  private static String at(String what, double timeS, int line, MomentPlaces places) {
    return line > 0 ? text("withPlace", what, places.of(timeS, line)) : what;
  }

  /** The program that ran already when the recording begins. */
  private static Optional<String> startedBefore(Recording recording) {
    var first = recording.atFrame(recording.firstFrame()).program();
    return first.line() > 0 ? Optional.of(ByteText.decoded(first.name())) : Optional.empty();
  }

  static List<Run> runs(
      List<RecordingMark> marks, double firstS, double lastS, Optional<String> startedBefore) {
    List<Run> runs = new ArrayList<>();
    Optional<Run> open = startedBefore.map(name -> new Run(firstS, lastS, name, false));
    for (RecordingMark mark : marks) {
      boolean failed = mark.kind() == RecordingMark.Kind.PROGRAM_FAILED;
      boolean ended = failed || mark.kind() == RecordingMark.Kind.PROGRAM_ENDED;
      if (ended) {
        // A secondary program may have failed before: the last of them ends the bar.
        open = open.map(run -> new Run(run.fromS, mark.timeS(), run.name, failed));
      } else if (mark.kind() == RecordingMark.Kind.PROGRAM_STARTED) {
        open.ifPresent(run -> runs.add(run.endedBy(mark.timeS())));
        open = Optional.of(new Run(mark.timeS(), lastS, ByteText.decoded(mark.text()), false));
      }
    }
    open.ifPresent(runs::add);
    return runs;
  }

  private static List<Bar> pauses(ColumnTrace state) {
    List<Bar> bars = new ArrayList<>();
    double fromS = Double.NaN;
    for (int i = 0; i < state.size(); i++) {
      boolean paused = state.highest(i) == PAUSED;
      if (paused && Double.isNaN(fromS)) {
        fromS = state.timeS(i);
      } else if (!paused && !Double.isNaN(fromS)) {
        bars.add(new Bar(fromS, state.timeS(i)));
        fromS = Double.NaN;
      }
    }
    if (!Double.isNaN(fromS)) {
      bars.add(new Bar(fromS, state.timeS(state.size())));
    }
    return bars;
  }

  private static List<Warning> warnings(Recording recording, double fromS, double toS) {
    List<Warning> warnings =
        recording.log(Math.max(fromS, recording.firstS()), toS).stream()
            .filter(entry -> entry.level() == LogEntry.Level.WARNING && entry.timeS() >= fromS)
            .map(
                entry ->
                    new Warning(
                        entry.timeS(),
                        Messages.shown(ByteText.decoded(entry.text())),
                        entry.place().map(ScriptPlace::line).orElse(0)))
            .toList();
    return warnings.subList(Math.max(0, warnings.size() - MAX_WARNINGS), warnings.size());
  }

  private static List<Bar> edges(
      Recording recording, TimeRange range, int buckets, boolean inputs) {
    boolean[] changed = new boolean[buckets];
    for (SignalBank bank : SignalBank.values()) {
      if (bank != SignalBank.FLAG && bank.input() == inputs) {
        mark(recording.scan(Column.digital(bank), range.fromS(), range.toS(), buckets), changed);
      }
    }
    double width = range.widthS() / buckets;
    List<Bar> bars = new ArrayList<>();
    for (int i = 0; i < buckets; i++) {
      if (changed[i]) {
        double fromS = range.fromS() + i * width;
        bars.add(new Bar(fromS, fromS + width));
      }
    }
    return bars;
  }

  private static void mark(ColumnTrace levels, boolean[] changed) {
    for (int i = 0; i < levels.size(); i++) {
      boolean within = levels.lowest(i) < levels.highest(i);
      boolean before = i > 0 && Math.abs(levels.last(i) - levels.last(i - 1)) > 0;
      changed[i] |= within || before;
    }
  }
}
