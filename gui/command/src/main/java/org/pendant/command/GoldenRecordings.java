package org.pendant.command;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListSet;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.FileDraft;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingException;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.RunTrack;
import org.pendant.recording.compare.TrackComparison;
import org.pendant.recording.compare.TrackDifference;
import org.pendant.recording.compare.TrackTolerance;
import org.pendant.testing.TestId;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.GoldenMark;
import org.pendant.testing.source.TestCase;
import org.pendant.testing.source.TestSources;

/**
 * Golden recordings: files {@code golden/*.rec} beside test files, which tests that are marked with
 * {@code @golden} are compared with, or written to.
 */
final class GoldenRecordings implements Goldens {
  static final Option UPDATE =
      Option.flag("--update-golden", "write the recordings of tests with @golden")
          .documented(
              "record each test that is marked with `@golden`, runs and is not red, in place of"
                  + " what it was compared with, see [testing.md](testing.md#golden-recordings)");

  /** Characters of the arguments of a case that stand in the name of its file. */
  private static final int MAX_ROW = 40;

  private final TestFilesOnDisk files;
  private final boolean update;
  private final Map<TestId, Difference> differences = new ConcurrentHashMap<>();
  private final SortedSet<String> written = new ConcurrentSkipListSet<>();

  /**
   * Golden recordings.
   *
   * @param update whether they are written, rather than compared
   */
  GoldenRecordings(TestFilesOnDisk files, boolean update) {
    this.files = files;
    this.update = update;
  }

  /** The files that were written. */
  SortedSet<String> written() {
    return written;
  }

  /**
   * Where a run first differed from its recording.
   *
   * @param frame in which it did
   * @param recording the file
   */
  record Difference(long frame, Path recording) {}

  /** Where a test differed; empty where it did not, or was not compared. */
  Optional<Difference> difference(TestId test) {
    return Optional.ofNullable(differences.get(test));
  }

  @Override
  public Run begins(TestCase test) {
    return update
        ? new Writing(name(test.id()))
        : new Comparing(test.id(), test.golden().orElseThrow());
  }

  /** The name of the recording of a test, one that every file system takes. */
  static String name(TestId id) {
    String file = id.file().substring(id.file().lastIndexOf('/') + 1).replaceAll("\\.script$", "");
    String row = "";
    if (!id.row().isEmpty()) {
      String plain = id.row().replaceAll("[^A-Za-z0-9.-]+", "_");
      // by the number rows stay apart that look the same without their signs, or are long
      row =
          String.format(
              ".%s.%08x",
              plain.substring(0, Math.min(MAX_ROW, plain.length())), id.row().hashCode());
    }
    return TestSources.beside(id.file(), "golden/" + file + "." + id.function() + row + ".rec");
  }

  private static Problem trouble(String code, String message) {
    return new Problem(code, message, 0, "");
  }

  /** Compares a run with its recording. */
  private final class Comparing implements Run {
    private final TestId test;
    private final String name;
    private final TrackTolerance tolerance;
    private final RunTrack track;
    private final List<RecordedProgram> programs = new ArrayList<>();
    private Drive drive;

    private Comparing(TestId test, GoldenMark mark) {
      this.test = test;
      name = name(test);
      tolerance = new TrackTolerance(mark.deg(), mark.mm(), mark.seconds());
      track = new RunTrack(mark.mm().isPresent());
    }

    @Override
    public void begins(Drive of) {
      drive = of;
      track.take(of.state());
    }

    @Override
    public void sees(ControllerState state) {
      track.take(state);
      RecordedProgram.startedIn(state, drive::programSource).ifPresent(programs::add);
    }

    @Override
    public Optional<Problem> passed() {
      try {
        Path file = files.golden(name);
        if (!Files.exists(file)) {
          return Optional.of(
              trouble(
                  "golden-missing",
                  "there is no recording " + name + " to compare with; --update-golden makes it"));
        }
        Recording recording = RecordingFile.open(file).recording();
        RunTrack before = RunTrack.of(recording, tolerance.mm().isPresent());
        Optional<TrackDifference> first = TrackComparison.first(track, before, tolerance);
        first.ifPresent(at -> differences.put(test, new Difference(at.frame(), file)));
        return first.map(this::problem);
      } catch (RecordingException e) {
        return Optional.of(trouble("golden-unreadable", e.getMessage()));
      } catch (IOException e) {
        return Optional.of(trouble("golden-unreadable", name + ": " + FileTrouble.reason(e)));
      } catch (UncheckedIOException e) {
        return Optional.of(
            trouble("golden-unreadable", name + ": " + FileTrouble.reason(e.getCause())));
      }
    }

    private Problem problem(TrackDifference difference) {
      String program =
          programs.reversed().stream()
              .filter(each -> each.frame() <= difference.frame())
              .findFirst()
              .map(each -> each.source().name())
              .orElse("");
      return new Problem(
          "golden-differs",
          difference.words()
              + "\nfirst difference from "
              + name
              + "; --update-golden takes the new run in its place",
          program.isEmpty() ? 0 : difference.line(),
          program);
    }

    @Override
    public void close() {
      // nothing is open between frames
    }
  }

  /** Writes the recording of a run. */
  private final class Writing implements Run {
    private final String name;
    private Optional<FileDraft> draft = Optional.empty();
    private Optional<TestRecorder> recorder = Optional.empty();
    private Optional<String> trouble = Optional.empty();

    private Writing(String name) {
      this.name = name;
    }

    @Override
    public void begins(Drive drive) {
      try {
        Path file = files.golden(name);
        if (Files.exists(file) && !isRecording(file)) {
          trouble = Optional.of(name + " is no recording, so it is not replaced");
          return;
        }
        Files.createDirectories(file.toAbsolutePath().getParent());
        draft = Optional.of(FileDraft.replacing(file));
        recorder = Optional.of(new TestRecorder(draft.get().out()));
        recorder.get().begins(drive);
      } catch (IOException e) {
        failed(e);
      } catch (UncheckedIOException e) {
        failed(e.getCause());
      }
    }

    private static boolean isRecording(Path file) throws IOException {
      try (InputStream in = Files.newInputStream(file)) {
        return RecordingFile.begins(in.readNBytes(RecordingFile.MARK_BYTES));
      }
    }

    private void failed(IOException why) {
      trouble = Optional.of(name + ": cannot be written, " + FileTrouble.reason(why));
    }

    @Override
    public void sees(ControllerState state) {
      if (trouble.isEmpty()) {
        try {
          recorder.orElseThrow().sees(state);
        } catch (UncheckedIOException e) {
          failed(e.getCause());
        }
      }
    }

    @Override
    public Optional<Problem> passed() {
      if (trouble.isEmpty()) {
        try {
          recorder.orElseThrow().close();
          draft.orElseThrow().commit();
          written.add(name);
        } catch (IOException e) {
          failed(e);
        }
      }
      return trouble.map(why -> trouble("golden-unwritten", why));
    }

    @Override
    public void close() {
      try {
        if (recorder.isPresent()) {
          recorder.get().close();
        }
        if (draft.isPresent()) {
          draft.get().close();
        }
      } catch (IOException _) {
        // what is left is a hidden file beside the recording; the test has its verdict
      }
    }
  }
}
