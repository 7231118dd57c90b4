package org.pendant.recording.compare;

import static org.pendant.recording.compare.CompareTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Column;
import org.pendant.recording.ColumnTrace;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingMark;

/**
 * First difference between the last runs of two recordings, frame by frame from the start of their
 * programs, bit for bit.
 *
 * @param sinceStartS when it comes, s since the programs began
 * @param nowS when that is in the first recording, s
 * @param line that the first program was at, from 1; 0 for none
 * @param lineBefore that the second program was at
 * @param what differs then, each with both values
 * @param measured whether all that programs decide is the same, and only readings differ
 * @param textLine the first line in which the texts of the programs differ, from 1; empty if they
 *     are the same
 */
public record FirstDifference(
    double sinceStartS,
    double nowS,
    int line,
    int lineBefore,
    List<String> what,
    boolean measured,
    OptionalInt textLine) {
  /** So many frames are looked at in one go. */
  private static final int CHUNK = 20_000;

  public FirstDifference {
    what = List.copyOf(what);
  }

  /** What is compared, and how its values are written. */
  private record Compared(String key, Object part, Column column, String unit) {
    /** What has no parts. */
    static Compared whole(String key, Column column) {
      return new Compared(key, "", column, "");
    }

    String values(double now, double before) {
      return part.equals("")
          ? text(key, shown(now), shown(before))
          : text(key, part, shown(now), shown(before));
    }

    private String shown(double value) {
      return unit.isEmpty()
          ? Long.toString(Math.round(value))
          : String.format(Locale.ROOT, "%.9g %s", value, unit);
    }
  }

  /** A run from its start to its end. */
  private record Run(Recording recording, long first, long last) {
    static Optional<Run> lastOf(Recording recording) {
      List<RecordingMark> marks = recording.marks();
      long end = recording.lastFrame();
      for (int i = marks.size() - 1; i >= 0; i--) {
        RecordingMark mark = marks.get(i);
        switch (mark.kind()) {
          case PROGRAM_ENDED, PROGRAM_FAILED -> end = mark.frame();
          case PROGRAM_STARTED -> {
            return Optional.of(new Run(recording, mark.frame(), end));
          }
          case LABEL, PROTECTIVE_STOP, SAFETY_STOP, ERROR, MESSAGE -> {}
        }
      }
      return Optional.empty();
    }

    long frames() {
      return last - first + 1;
    }

    ColumnTrace scan(Column column, long offset, int frames) {
      double fromS = (first + offset) * FrameTime.FRAME_S;
      // A little less, so that rounding puts no frame into the stretch of the one before.
      double toS = fromS + frames * FrameTime.FRAME_S * (1 - FrameTime.ROUNDING);
      return recording.scan(column, fromS, toS, frames);
    }

    String text() {
      return recording.programs().stream()
          .filter(each -> each.frame() <= first)
          .reduce((one, other) -> other)
          .map(RecordedProgram::source)
          .map(source -> source.text())
          .orElse("");
    }
  }

  /**
   * Compares the last runs of two recordings; too slow for the dispatch thread.
   *
   * @param recording the newer one
   * @param before the older one
   * @return empty if both did the same in every frame
   * @throws IllegalArgumentException if no program runs in one of them
   */
  public static Optional<FirstDifference> between(Recording recording, Recording before) {
    Run now = run(recording, "the first recording");
    Run then = run(before, "the second recording");
    Optional<FirstDifference> decided = search(now, then, decisions(), false);
    return decided.isPresent() ? decided : search(now, then, readings(), true);
  }

  /** How many frames the last run of a recording has; empty if no program runs in it. */
  public static Optional<Long> framesOfRun(Recording recording) {
    return Run.lastOf(recording).map(Run::frames);
  }

  private static Run run(Recording recording, String which) {
    return Run.lastOf(recording)
        .orElseThrow(() -> new IllegalArgumentException("no program starts in " + which));
  }

  private static List<Compared> decisions() {
    List<Compared> all = new ArrayList<>();
    all.add(Compared.whole("lineWas", Column.line()));
    all.add(Compared.whole("programWas", Column.programState()));
    for (SignalBank bank : SignalBank.values()) {
      for (int i = 0; i < bank.size(); i++) {
        Signal signal = new Signal(bank, i);
        all.add(new Compared("signalWas", signal, Column.digital(signal), ""));
      }
    }
    addJoints(all, "targetPositionWas", "target_q", "rad");
    return all;
  }

  private static List<Compared> readings() {
    List<Compared> all = new ArrayList<>();
    addJoints(all, "positionWas", "actual_q", "rad");
    return all;
  }

  private static void addJoints(List<Compared> all, String key, String quantity, String unit) {
    for (int i = 0; i < Joints.COUNT; i++) {
      all.add(new Compared(key, i, Column.of(quantity, i), unit));
    }
  }

  private static Optional<FirstDifference> search(
      Run now, Run before, List<Compared> compared, boolean measured) {
    long common = Math.min(now.frames(), before.frames());
    for (long offset = 0; offset < common; offset += CHUNK) {
      int frames = (int) Math.min(CHUNK, common - offset);
      int first = frames;
      List<String> what = new ArrayList<>();
      for (Compared each : compared) {
        ColumnTrace one = now.scan(each.column(), offset, frames);
        ColumnTrace other = before.scan(each.column(), offset, frames);
        int index = firstDifference(one, other, first);
        if (index < first) {
          first = index;
          what.clear();
        }
        if (index == first && index < frames) {
          what.add(each.values(one.last(index), other.last(index)));
        }
      }
      if (first < frames) {
        return Optional.of(at(now, before, offset + first, what, measured));
      }
    }
    if (measured || now.frames() == before.frames()) {
      return Optional.empty();
    }
    boolean longer = now.frames() > before.frames();
    String ended = longer ? text("runsOn") : CompareTexts.text("endsEarlier");
    return Optional.of(at(now, before, common, List.of(ended), false));
  }

  /** The first index up to {@code limit} at which two traces differ; more than that for none. */
  private static int firstDifference(ColumnTrace one, ColumnTrace other, int limit) {
    for (int i = 0; i <= limit && i < one.size(); i++) {
      if (Double.doubleToLongBits(one.last(i)) != Double.doubleToLongBits(other.last(i))) {
        return i;
      }
    }
    return Integer.MAX_VALUE;
  }

  private static FirstDifference at(
      Run now, Run before, long offset, List<String> what, boolean measured) {
    return new FirstDifference(
        offset * FrameTime.FRAME_S,
        (now.first() + offset) * FrameTime.FRAME_S,
        lineAt(now, offset),
        lineAt(before, offset),
        what,
        measured,
        firstLine(now.text(), before.text()));
  }

  private static int lineAt(Run run, long offset) {
    return run.recording().atFrame(Math.min(run.first() + offset, run.last())).program().line();
  }

  private static OptionalInt firstLine(String now, String before) {
    if (now.equals(before)) {
      return OptionalInt.empty();
    }
    List<String> lines = now.lines().toList();
    List<String> linesBefore = before.lines().toList();
    int line = 0;
    while (line < Math.min(lines.size(), linesBefore.size())
        && lines.get(line).equals(linesBefore.get(line))) {
      line++;
    }
    return OptionalInt.of(line + 1);
  }

  /** All of it in sentences. */
  public String words() {
    return words(FirstDifference::line, what.size());
  }

  /**
   * It in sentences.
   *
   * @param place what a line of the first program is called, such as {@code node 15 Feeder}
   * @param most how many of the values that differ are told, at most
   */
  public String words(IntFunction<String> place, int most) {
    String timeS = String.format(Locale.ROOT, "%.3f", sinceStartS);
    String values = String.join("; ", what.subList(0, Math.min(most, what.size())));
    String told = what.size() > most ? text("andMore", values, what.size() - most) : values;
    String words;
    if (lineBefore == line) {
      words = text(measured ? "readingsDiffer" : "differs", timeS, place.apply(line), told);
    } else {
      boolean same = textLine.isEmpty() || lineBefore < textLine.getAsInt();
      String before = same ? place.apply(lineBefore) : line(lineBefore);
      String key = measured ? "readingsDifferElsewhere" : "differsElsewhere";
      words = text(key, timeS, place.apply(line), before, told);
    }
    return textLine.isPresent()
        ? text("textsDiffer", words, place.apply(textLine.getAsInt()))
        : words;
  }

  private static String line(int line) {
    return text("line", line);
  }
}
