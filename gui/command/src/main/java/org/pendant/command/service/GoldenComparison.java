package org.pendant.command.service;

import static org.pendant.command.service.GoldenTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.RecordingException;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.MalformedTrack;
import org.pendant.recording.compare.RunTrack;
import org.pendant.recording.compare.TrackComparison;
import org.pendant.recording.compare.TrackDifference;
import org.pendant.recording.compare.TrackText;
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

  private static final String ENDING = ".golden";
  private static final int MAX_BYTES = 64 << 20;

  /** What places are written with at the finest, degrees or mm. */
  private static final double MIN_FINE = 1e-3;

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
     * The file of a name.
     *
     * @throws IOException if it may not be used; its message says why, for people
     */
    Path file(String name) throws IOException;

    /**
     * The run differs from its recording.
     *
     * @param first where it does first
     * @param recording the file
     */
    default void differs(TrackDifference first, Path recording) {}
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
    tolerance = tolerance(mark);
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
      Path file = place.file(name);
      if (!Files.exists(file)) {
        file = place.file(wholeName(name));
      }
      if (!Files.exists(file)) {
        return Optional.of(trouble("golden-missing", text("goldenMissing", name)));
      }
      RunTrack before = read(file, tolerance.mm().isPresent());
      Optional<String> coarse = tooCoarse(before);
      if (coarse.isPresent()) {
        return Optional.of(trouble("golden-unreadable", coarse.get()));
      }
      Path compared = file;
      Optional<TrackDifference> first = TrackComparison.first(track, before, tolerance);
      first.ifPresent(at -> place.differs(at, compared));
      return first.map(this::problem);
    } catch (RecordingException e) {
      return Optional.of(trouble("golden-unreadable", e.getMessage()));
    } catch (MalformedTrack e) {
      return Optional.of(
          trouble("golden-unreadable", text("goldenUnreadable", name, e.getMessage())));
    } catch (IOException e) {
      return Optional.of(trouble("golden-unreadable", name + ": " + FileTrouble.reason(e)));
    } catch (UncheckedIOException e) {
      return Optional.of(
          trouble("golden-unreadable", name + ": " + FileTrouble.reason(e.getCause())));
    }
  }

  /**
   * Reads a golden recording, one of the compact form or a whole one of earlier versions.
   *
   * @param withTcp whether it has to have the TCP as well
   * @throws RecordingException if it is a whole one that cannot be read
   */
  public static RunTrack read(Path file, boolean withTcp) throws IOException, MalformedTrack {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] head = in.readNBytes(RecordingFile.MARK_BYTES);
      if (RecordingFile.begins(head)) {
        return RunTrack.of(RecordingFile.open(file).recording(), withTcp);
      }
      byte[] rest = in.readNBytes(MAX_BYTES);
      byte[] all = Arrays.copyOf(head, head.length + rest.length);
      System.arraycopy(rest, 0, all, head.length, rest.length);
      return TrackText.read(all);
    }
  }

  /** Why a recording cannot be compared as closely as the test wants; empty where it can. */
  private Optional<String> tooCoarse(RunTrack before) {
    boolean deg = tolerance.deg().isPresent() && before.within().deg() > fine(tolerance.deg());
    boolean mm =
        tolerance.mm().isPresent()
            && (!before.hasTcp() || before.within().mm() > fine(tolerance.mm()));
    return deg || mm ? Optional.of(GoldenTexts.text("goldenTooCoarse", name)) : Optional.empty();
  }

  private static double fine(OptionalDouble most) {
    return Math.max(MIN_FINE, most.getAsDouble() / 2);
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
        difference.words() + "\n" + GoldenTexts.text("firstDifference", name),
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

  /** What a mark allows. */
  public static TrackTolerance tolerance(GoldenMark mark) {
    return new TrackTolerance(mark.deg(), mark.mm(), mark.seconds());
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
    return TestSources.beside(id.file(), "golden/" + file + "." + id.function() + row + ENDING);
  }

  /** The name of the recording of an earlier version, which was a whole one. */
  public static String wholeName(String name) {
    return name.substring(0, name.length() - ENDING.length()) + ".rec";
  }
}
