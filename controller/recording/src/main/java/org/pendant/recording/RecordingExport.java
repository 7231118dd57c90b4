package org.pendant.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariablePath;

/**
 * Recording export: writes a stretch of a recording to a file. It takes a while: not for the
 * dispatch thread.
 */
public final class RecordingExport {
  private RecordingExport() {}

  /**
   * Writes the frames from {@code fromS} to {@code toS}, robot time in s, as a {@code .rec} file,
   * which is created, or replaced when all of it is written.
   */
  public static void toRec(Recording recording, double fromS, double toS, Path file)
      throws IOException {
    AtomicFile.write(file, out -> toRec(recording, fromS, toS, out));
  }

  /** As {@link #toRec(Recording, double, double, Path)}, to a stream, which is closed. */
  static void toRec(Recording recording, double fromS, double toS, OutputStream out)
      throws IOException {
    long from = recording.frameAt(fromS);
    long to = Math.max(from, recording.frameAt(toS));
    // what was kept is kept again, however little it is
    try (out;
        RecordingWriter writer =
            new RecordingWriter(out, recording.atFrame(from), 0, recording.received())) {
      ProgramTexts texts = recording.texts().from(from);
      for (RecordedProgram each : texts.all()) {
        if (each.frame() <= to) {
          writer.note(each);
        }
      }
      recording.visit(
          from,
          to,
          entry -> {
            if (entry.frame() > from) {
              writer.write(recording.snapshots().of(entry, entry.frame()));
            }
          });
      writer.end(to);
    }
  }

  /**
   * Writes the frames from {@code fromS} to {@code toS}, robot time in s, as comma-separated values
   * with one row a frame, see {@link Recorder}. Variables that were traced in every frame have
   * columns. The file is created, or replaced when all of it is written.
   */
  public static void toCsv(Recording recording, double fromS, double toS, Path file)
      throws IOException {
    AtomicFile.write(file, out -> toCsv(recording, fromS, toS, out));
  }

  /** As {@link #toCsv(Recording, double, double, Path)}, to a stream, which is closed. */
  public static void toCsv(Recording recording, double fromS, double toS, OutputStream out)
      throws IOException {
    long from = recording.frameAt(fromS);
    long to = recording.frameAt(toS);
    try (Recorder recorder = Recorder.to(out, traced(recording, from, to))) {
      for (long frame = from; frame <= to; frame++) {
        recorder.write(recording.atFrame(frame));
      }
    }
  }

  private static List<VariablePath> traced(Recording recording, long from, long to) {
    Set<String> names = new LinkedHashSet<>();
    recording.look(
        from,
        to,
        entry -> {
          if (names.isEmpty() || entry.changed(SnapshotPart.TRACED)) {
            names.addAll(((TracedVariables) entry.part(SnapshotPart.TRACED)).names());
          }
        });
    return names.stream().filter(VariablePath::isOne).map(VariablePath::of).toList();
  }
}
