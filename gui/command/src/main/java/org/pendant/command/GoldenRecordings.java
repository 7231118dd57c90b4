package org.pendant.command;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListSet;
import org.pendant.command.service.GoldenComparison;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.FileDraft;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordingFile;
import org.pendant.testing.TestId;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.TestCase;

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
    String name = GoldenComparison.name(test.id());
    return update
        ? new Writing(name)
        : new GoldenComparison(
            name, new Compared(this, test.id(), name), test.golden().orElseThrow());
  }

  private static Problem trouble(String code, String message) {
    return new Problem(code, message, 0, "");
  }

  /** Where the recording of a test is, and how the test differs from it. */
  private record Compared(GoldenRecordings all, TestId test, String name)
      implements GoldenComparison.Place {
    @Override
    public Path file() throws IOException {
      return all.files.golden(name);
    }

    @Override
    public void differs(long frame, Path recording) {
      all.differences.put(test, new Difference(frame, recording));
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
