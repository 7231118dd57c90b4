package org.pendant.command.service;

import static org.pendant.command.service.GoldenTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.RunTrack;
import org.pendant.recording.compare.TrackText;
import org.pendant.recording.compare.TrackTolerance;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.GoldenMark;

/**
 * Golden writing: writes the recording of a test that is marked with {@code @golden}, in place of
 * an earlier one, when the test has passed.
 */
public final class GoldenWriting implements Goldens.Run {
  private final String name;
  private final GoldenComparison.Place place;
  private final TrackTolerance tolerance;
  private final RunTrack track;
  private final Consumer<String> written;

  /**
   * A recording that is to be written.
   *
   * @param name of it, for people
   * @param place asked when the test has passed
   * @param written is told the name when it is on disk
   */
  public GoldenWriting(
      String name, GoldenComparison.Place place, GoldenMark mark, Consumer<String> written) {
    this.name = name;
    this.place = place;
    this.written = written;
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
  public Optional<Goldens.Problem> passed() {
    try {
      Path file = place.file(name);
      if (Files.exists(file) && !TrackText.begins(head(file, TrackText.MARK_BYTES))) {
        return Optional.of(trouble(text("notReplaced", name)));
      }
      Files.createDirectories(file.toAbsolutePath().getParent());
      AtomicFile.write(file, TrackText.of(track, tolerance));
      Path whole = place.file(GoldenComparison.wholeName(name));
      if (Files.exists(whole) && RecordingFile.begins(head(whole, RecordingFile.MARK_BYTES))) {
        Files.delete(whole);
      }
      written.accept(name);
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(trouble(text("notWritten", name, FileTrouble.reason(e))));
    }
  }

  private static Goldens.Problem trouble(String why) {
    return new Goldens.Problem("golden-unwritten", why, 0, "");
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
