package org.pendant.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListSet;
import org.pendant.command.service.GoldenComparison;
import org.pendant.command.service.GoldenWriting;
import org.pendant.recording.compare.TrackDifference;
import org.pendant.testing.TestId;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.TestCase;

/**
 * Golden recordings: files {@code golden/*.golden} beside test files, which tests that are marked
 * with {@code @golden} are compared with, or written to.
 */
final class GoldenRecordings implements Goldens {
  static final Option UPDATE =
      Option.flag("--update-golden")
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
        ? new GoldenWriting(name, files::golden, test.golden().orElseThrow(), written::add)
        : new GoldenComparison(name, new Compared(this, test.id()), test.golden().orElseThrow());
  }

  /** Where the recording of a test is, and how the test differs from it. */
  private record Compared(GoldenRecordings all, TestId test) implements GoldenComparison.Place {
    @Override
    public Path file(String name) throws IOException {
      return all.files.golden(name);
    }

    @Override
    public void differs(TrackDifference first, Path recording) {
      all.differences.put(test, new Difference(first.frame(), recording));
    }
  }
}
