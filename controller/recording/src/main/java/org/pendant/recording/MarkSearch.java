package org.pendant.recording;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.recording.RecordingMark.Kind;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramLabel;

/** Mark search: finds what is worth a mark. */
final class MarkSearch {
  /** Marks that are kept; of more the oldest are left out. */
  static final int MOST = 10_000;

  /** Labels are left out that come nearer to the one before than this part of the recording. */
  private static final int LABELS = 2000;

  private final Recording recording;
  private final long labelFrames;
  private final ArrayDeque<RecordingMark> marks = new ArrayDeque<>();
  private Optional<ProgramStatus> program = Optional.empty();
  private Optional<SafetyStop> stop = Optional.empty();
  private List<ProgramLabel> labels = List.of();
  private Optional<ProgramLabel> label = Optional.empty();
  private long labelFrame = Long.MIN_VALUE / 2;

  MarkSearch(Recording recording) {
    this.recording = recording;
    labelFrames = recording.frames() / LABELS;
  }

  List<RecordingMark> marks() {
    recording.look(recording.firstFrame(), recording.lastFrame(), this::visit);
    return List.copyOf(marks);
  }

  private void visit(SegmentCursor entry) {
    ProgramStatus now = (ProgramStatus) entry.part(SnapshotPart.PROGRAM);
    int line = now.line();
    if (entry.changed(SnapshotPart.NEWS)) {
      news((FrameDelta) entry.part(SnapshotPart.NEWS), entry.frame(), line);
    }
    if (entry.changed(SnapshotPart.SAFETY)) {
      safety((SafetyStatus) entry.part(SnapshotPart.SAFETY), entry.frame(), line);
    }
    // the first entry of a segment has it in any case, changed or not
    if (entry.changed(SnapshotPart.PROGRAM) && line > 0 && program.filter(now::equals).isEmpty()) {
      label(entry.frame(), line);
    }
    program = Optional.of(now);
  }

  private void news(FrameDelta frameDelta, long frame, int line) {
    for (ProgramEvent each : frameDelta.events()) {
      switch (each) {
        case ProgramEvent.Started started -> {
          add(Kind.PROGRAM_STARTED, frame, started.name(), line);
          labels = started.labels();
          label = Optional.empty();
        }
        case ProgramEvent.Ended ended -> {
          if (ended.ending() instanceof Ending.Failed failed) {
            String why = failed.failure().message();
            add(Kind.PROGRAM_FAILED, frame, why, failed.failure().line());
          } else {
            add(Kind.PROGRAM_ENDED, frame, ended.name(), line);
          }
        }
        case ProgramEvent.SecondaryFailed failed ->
            add(Kind.PROGRAM_FAILED, frame, failed.failure().message(), failed.failure().line());
      }
    }
    for (Popup each : frameDelta.popups()) {
      add(Kind.MESSAGE, frame, each.text(), line);
    }
    for (Question each : frameDelta.questions()) {
      add(Kind.MESSAGE, frame, each.text(), line);
    }
    for (LogEntry each : frameDelta.entries()) {
      if (each.level() == LogEntry.Level.ERROR
          && each.origin() != LogEntry.Origin.ENDING
          && each.origin() != LogEntry.Origin.SAFETY) {
        add(Kind.ERROR, frame, each.text(), each.place().map(ScriptPlace::line).orElse(line));
      }
    }
  }

  private void safety(SafetyStatus status, long frame, int line) {
    if (status.stop().isPresent() && !status.stop().equals(stop)) {
      SafetyStop now = status.stop().get();
      Kind kind =
          now.mode() == SafetyMode.PROTECTIVE_STOP ? Kind.PROTECTIVE_STOP : Kind.SAFETY_STOP;
      add(kind, frame, now.message(), status.stopPlace().map(at -> at.line()).orElse(line));
    }
    stop = status.stop();
  }

  private void label(long frame, int line) {
    Optional<ProgramLabel> now = ProgramLabel.at(labels, line);
    if (now.isPresent() && !now.equals(label) && frame - labelFrame >= labelFrames) {
      add(Kind.LABEL, frame, now.get().text(), line);
      labelFrame = frame;
    }
    label = now;
  }

  private void add(Kind kind, long frame, String text, int line) {
    if (marks.size() == MOST) {
      marks.removeFirst();
    }
    marks.addLast(new RecordingMark(kind, frame, Recording.timeS(frame), text, line));
  }
}
