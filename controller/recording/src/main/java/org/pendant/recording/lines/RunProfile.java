package org.pendant.recording.lines;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.models.time.FrameTime;

/**
 * Run profile: what the lines of a program took of its last run, as far as it has come.
 *
 * @param run how many programs the profiler has seen start, this one included; 0 before the first
 * @param name of the program
 * @param firstFrame in which it started
 * @param lines those that the main thread was seen on, from the first
 */
public record RunProfile(long run, String name, long firstFrame, List<LineStatistics> lines) {
  /** Nothing has run. */
  public static final RunProfile NONE = new RunProfile(0, "", 0, List.of());

  /** Copies the list. */
  public RunProfile {
    lines = List.copyOf(lines);
  }

  /** A limit that was come near to, and the line that did it. */
  public record Moment(Worst worst, int line) {}

  /** How long the program has run, without pauses, s. */
  public double timeS() {
    return frames() * FrameTime.FRAME_S;
  }

  private long frames() {
    return lines.stream().mapToLong(LineStatistics::frames).sum();
  }

  /** What a line took. */
  public Optional<LineStatistics> line(int line) {
    return lines.stream().filter(each -> each.line() == line).findFirst();
  }

  /** How much of the time the line took, 0 to 1. */
  public double share(LineStatistics line) {
    long all = frames();
    return all == 0 ? 0 : line.frames() / (double) all;
  }

  /** Where the arm came nearest to each of its limits, in the order of the margins. */
  public List<Moment> worst() {
    return Stream.of(Margin.values()).flatMap(each -> worst(each).stream()).toList();
  }

  private Optional<Moment> worst(Margin margin) {
    Comparator<Moment> byUse = Comparator.comparingDouble(each -> -each.worst().value());
    return lines.stream()
        .flatMap(line -> line.worst(margin).map(each -> new Moment(each, line.line())).stream())
        .max(margin.isShare() ? byUse.reversed() : byUse);
  }
}
