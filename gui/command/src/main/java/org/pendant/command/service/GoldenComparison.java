package org.pendant.command.service;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Drive;
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
import org.pendant.testing.source.TestSources;

/**
 * Golden comparison: compares a run of a test that is marked with {@code @golden} with its
 * recording.
 */
public final class GoldenComparison implements Goldens.Run {
  /** Characters of the arguments of a case that stand in the name of its file. */
  private static final int MAX_ROW = 40;

  private final String name;
  private final Place place;
  private final TrackTolerance tolerance;
  private final RunTrack track;
  private final List<RecordedProgram> programs = new ArrayList<>();
  private Drive drive;

  /** Where recordings are. */
  @FunctionalInterface
  public interface Place {
    /**
     * The file of the recording.
     *
     * @throws IOException if it may not be used; its message says why, for people
     */
    Path file() throws IOException;

    /**
     * The run differs from its recording.
     *
     * @param frame in which it does first
     * @param recording the file
     */
    default void differs(long frame, Path recording) {}
  }

  /**
   * A comparison.
   *
   * @param name of the recording, for people
   * @param place asked when the test has passed
   */
  public GoldenComparison(String name, Place place, GoldenMark mark) {
    this.name = name;
    this.place = place;
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
  public Optional<Goldens.Problem> passed() {
    try {
      Path file = place.file();
      if (!Files.exists(file)) {
        return Optional.of(
            trouble(
                "golden-missing",
                "there is no recording " + name + " to compare with; --update-golden makes it"));
      }
      Recording recording = RecordingFile.open(file).recording();
      RunTrack before = RunTrack.of(recording, tolerance.mm().isPresent());
      Optional<TrackDifference> first = TrackComparison.first(track, before, tolerance);
      first.ifPresent(at -> place.differs(at.frame(), file));
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

  private Goldens.Problem problem(TrackDifference difference) {
    String program =
        programs.reversed().stream()
            .filter(each -> each.frame() <= difference.frame())
            .findFirst()
            .map(each -> each.source().name())
            .orElse("");
    return new Goldens.Problem(
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

  private static Goldens.Problem trouble(String code, String message) {
    return new Goldens.Problem(code, message, 0, "");
  }

  /** The name of the recording of a test, one that every file system takes. */
  public static String name(TestId id) {
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
}
