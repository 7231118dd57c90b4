package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.command.service.GoldenComparison;
import org.pendant.command.text.CommandLanguage;
import org.pendant.recording.RecordingException;
import org.pendant.recording.compare.MalformedTrack;
import org.pendant.recording.compare.RunTrack;
import org.pendant.recording.compare.TrackComparison;
import org.pendant.recording.compare.TrackDifference;
import org.pendant.recording.compare.TrackTolerance;

/**
 * Comparison of two runs of a test of which one is a golden recording, the other one as well or a
 * whole recording of the test: what {@code @golden} compares, within its limits.
 */
final class GoldenFileComparison {
  private static final double STANDARD_DEG = 0.1;
  private static final double STANDARD_S = 0.01;

  /** What comes still later is looked for in too many frames. */
  private static final double MAX_S = 5;

  private GoldenFileComparison() {}

  /** Whether one of the operands is such a recording. */
  static boolean isMeant(List<String> operands) {
    return operands.size() == 2 && operands.stream().anyMatch(GoldenFileComparison::isGolden);
  }

  /** Whether a file is a golden recording, by its name. */
  static boolean isGolden(String name) {
    return ends(name, ".golden");
  }

  private static boolean ends(String name, String ending) {
    return name.toLowerCase(Locale.ROOT).endsWith(ending);
  }

  /**
   * Says what differs first.
   *
   * @param newer name of the file with the run that is looked at
   * @param older name of the one that it is compared with
   * @param limits of {@code deg}, {@code mm} and {@code s}
   */
  static ExitCode run(
      String newer, String older, List<CompareLimit> limits, SourceFiles files, Console console)
      throws UsageException {
    TrackTolerance wanted = tolerance(limits);
    boolean tcp = wanted.mm().isPresent();
    RunTrack now = read(newer, tcp, files);
    RunTrack before = read(older, tcp, files);
    TrackTolerance within =
        new TrackTolerance(
            wider(wanted.deg(), now.within().deg()),
            wider(wanted.mm(), now.within().mm()),
            wanted.seconds());
    Optional<TrackDifference> first = TrackComparison.first(now, before, within);
    if (first.isEmpty()) {
      console.print(text("sameWithin", words(wanted)));
      return ExitCode.DONE;
    }
    console.print(newer + ": " + CommandLanguage.shown(first.get().words()));
    return ExitCode.LIMIT_EXCEEDED;
  }

  private static TrackTolerance tolerance(List<CompareLimit> limits) throws UsageException {
    OptionalDouble deg = OptionalDouble.empty();
    OptionalDouble mm = OptionalDouble.empty();
    double seconds = STANDARD_S;
    for (CompareLimit each : limits) {
      switch (each.name()) {
        case "deg" -> deg = OptionalDouble.of(each.most());
        case "mm" -> mm = OptionalDouble.of(each.most());
        case "s" -> seconds = each.most();
        default ->
            throw new UsageException(text("goldenLimits", CompareLimit.OPTION.name(), each.name()));
      }
    }
    if (seconds > MAX_S) {
      throw new UsageException(text("secondsMustBe", CompareLimit.OPTION.name(), seconds, MAX_S));
    }
    boolean standard = deg.isEmpty() && mm.isEmpty();
    return new TrackTolerance(standard ? OptionalDouble.of(STANDARD_DEG) : deg, mm, seconds);
  }

  /** What a golden recording may be off by itself is added, as it is for the older one. */
  private static OptionalDouble wider(OptionalDouble most, double off) {
    return most.isPresent() ? OptionalDouble.of(most.getAsDouble() + off) : most;
  }

  private static String words(TrackTolerance within) {
    StringBuilder words = new StringBuilder();
    within.deg().ifPresent(deg -> words.append(plain(deg)).append("\u00b0, "));
    within.mm().ifPresent(mm -> words.append(plain(mm)).append(" mm, "));
    return words.append(plain(within.seconds())).append(" s").toString();
  }

  /** As people write it. */
  private static String plain(double number) {
    return Double.toString(number).replaceAll("\\.0$", "");
  }

  /**
   * Reads a run of a test.
   *
   * @param withTcp whether it has to have places of the TCP
   * @throws UsageException when it cannot be read, or is none
   */
  static RunTrack read(String name, boolean withTcp, SourceFiles files) throws UsageException {
    Path path = files.path("theRecording", name);
    if (Files.isDirectory(path)) {
      throw new UsageException(text("directoryNotRecording", name));
    }
    if (!isGolden(name) && !ends(name, ".rec")) {
      throw new UsageException(text("noTestRecording", name));
    }
    try {
      RunTrack track = GoldenComparison.read(path, withTcp);
      if (withTcp && !track.hasTcp()) {
        throw new UsageException(text("noTcpPlaces", name));
      }
      return track;
    } catch (MalformedTrack e) {
      throw new UsageException(name + " " + CommandLanguage.shown(e.getMessage()));
    } catch (RecordingException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }
}
