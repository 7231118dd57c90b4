package org.pendant.desktop.waveform;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.io.InputChange;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Column;
import org.pendant.recording.ColumnTrace;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingMark;

/**
 * Waveform capture: what the digital signals did in the last run of a recording. Too slow for the
 * dispatch thread.
 *
 * @param sheet the inputs that changed, from the start of the program on
 * @param outputs the outputs that changed, to be seen beside them
 * @param lengthS how long the run took until its end or the end of the recording, s
 */
record WaveformCapture(WaveSheet sheet, List<OutputRow> outputs, double lengthS) {
  /** No run is known. */
  static final WaveformCapture NONE = new WaveformCapture(WaveSheet.EMPTY, List.of(), 0);

  /** Longer runs are looked at from their start to there, in frames. */
  private static final int MAX_FRAMES = 600 * FrameTime.FRAMES_PER_SECOND;

  WaveformCapture {
    outputs = List.copyOf(outputs);
  }

  /**
   * A digital output over the time since the start of the program.
   *
   * @param edgesS when it changed, s
   * @param high whether it was high at the start
   */
  record OutputRow(String signal, boolean high, List<Double> edgesS) {
    OutputRow {
      edgesS = List.copyOf(edgesS);
    }
  }

  /** The last run; empty if there was none. */
  static Optional<WaveformCapture> of(Recording recording) {
    List<RecordingMark> marks = recording.marks();
    for (int i = marks.size() - 1; i >= 0; i--) {
      if (marks.get(i).kind() == RecordingMark.Kind.PROGRAM_STARTED) {
        return Optional.of(of(recording, marks.get(i), end(marks.subList(i, marks.size()))));
      }
    }
    return Optional.empty();
  }

  private static OptionalDouble end(List<RecordingMark> run) {
    return run.stream()
        .filter(
            mark ->
                mark.kind() == RecordingMark.Kind.PROGRAM_ENDED
                    || mark.kind() == RecordingMark.Kind.PROGRAM_FAILED)
        .mapToDouble(RecordingMark::timeS)
        .findFirst();
  }

  private static WaveformCapture of(Recording recording, RecordingMark start, OptionalDouble endS) {
    double fromS = start.timeS();
    double toS = endS.orElse(recording.lastS());
    int frames = Math.clamp(Math.round((toS - fromS) / FrameTime.FRAME_S) + 1, 1, MAX_FRAMES);
    // A little less, so that rounding puts no frame into the bucket of the one before.
    double lastS = fromS + frames * FrameTime.FRAME_S * (1 - FrameTime.ROUNDING);
    List<WaveRow> rows = new ArrayList<>();
    List<OutputRow> outputs = new ArrayList<>();
    for (SignalBank bank : SignalBank.values()) {
      if (bank == SignalBank.FLAG) {
        continue;
      }
      for (int i = 0; i < bank.size(); i++) {
        Signal signal = new Signal(bank, i);
        ColumnTrace levels = recording.scan(Column.digital(signal), fromS, lastS, frames);
        List<Double> edges = edges(levels, frames);
        if (edges.isEmpty()) {
          continue;
        }
        boolean high = levels.last(0) > 0;
        if (bank.input()) {
          rows.add(row(signal.toString(), high, edges));
        } else {
          outputs.add(new OutputRow(signal.toString(), high, edges));
        }
      }
    }
    WaveSheet sheet = new WaveSheet(rows, OptionalDouble.empty());
    return new WaveformCapture(sheet, outputs, frames * FrameTime.FRAME_S);
  }

  /** Times since the start at which a level was another one than in the frame before. */
  private static List<Double> edges(ColumnTrace levels, int frames) {
    List<Double> edges = new ArrayList<>();
    for (int i = 1; i < Math.min(levels.size(), frames); i++) {
      if (Math.abs(levels.last(i) - levels.last(i - 1)) > 0) {
        edges.add(i / (double) FrameTime.FRAMES_PER_SECOND);
      }
    }
    return edges;
  }

  private static WaveRow row(String signal, boolean high, List<Double> edges) {
    List<InputChange> changes = new ArrayList<>();
    boolean level = high;
    changes.add(new InputChange(0, signal, Boolean.toString(level)));
    for (double edgeS : edges) {
      level = !level;
      changes.add(new InputChange(edgeS, signal, Boolean.toString(level)));
    }
    return new WaveRow(signal, changes);
  }
}
