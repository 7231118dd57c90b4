package org.pendant.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListSet;
import org.pendant.command.service.GoldenComparison;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.RunTrack;
import org.pendant.recording.compare.TrackText;
import org.pendant.recording.compare.TrackTolerance;
import org.pendant.testing.TestId;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.GoldenMark;
import org.pendant.testing.source.TestCase;

/**
 * Golden recordings: files {@code golden/*.golden} beside test files, which tests that are marked
 * with {@code @golden} are compared with, or written to.
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
        ? new Writing(name, test.golden().orElseThrow())
        : new GoldenComparison(name, new Compared(this, test.id()), test.golden().orElseThrow());
  }

  private static Problem trouble(String code, String message) {
    return new Problem(code, message, 0, "");
  }

  /** Where the recording of a test is, and how the test differs from it. */
  private record Compared(GoldenRecordings all, TestId test) implements GoldenComparison.Place {
    @Override
    public Path file(String name) throws IOException {
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
    private final TrackTolerance tolerance;
    private final RunTrack track;

    private Writing(String name, GoldenMark mark) {
      this.name = name;
      tolerance = GoldenComparison.tolerance(mark);
      track = new RunTrack(mark.mm().isPresent());
    }

    @Override
    public void begins(Drive drive) {
      track.take(drive.state());
    }

    @Override
    public void sees(ControllerState state) {
      track.take(state);
    }

    @Override
    public Optional<Problem> passed() {
      try {
        Path file = files.golden(name);
        if (Files.exists(file) && !TrackText.begins(head(file, TrackText.MARK_BYTES))) {
          return Optional.of(
              trouble("golden-unwritten", name + " is no recording, so it is not replaced"));
        }
        Files.createDirectories(file.toAbsolutePath().getParent());
        AtomicFile.write(file, TrackText.of(track, tolerance));
        Path whole = files.golden(GoldenComparison.wholeName(name));
        if (Files.exists(whole) && RecordingFile.begins(head(whole, RecordingFile.MARK_BYTES))) {
          Files.delete(whole);
        }
        written.add(name);
        return Optional.empty();
      } catch (IOException e) {
        return Optional.of(
            trouble("golden-unwritten", name + ": cannot be written, " + FileTrouble.reason(e)));
      }
    }

    private static byte[] head(Path file, int bytes) throws IOException {
      try (InputStream in = Files.newInputStream(file)) {
        return in.readNBytes(bytes);
      }
    }

    @Override
    public void close() {
      // nothing is open between frames
    }
  }
}
