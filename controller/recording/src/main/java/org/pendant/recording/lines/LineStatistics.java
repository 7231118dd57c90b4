package org.pendant.recording.lines;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.models.time.FrameTime;

/**
 * Line statistics: what one line of a program took of a run, while its main thread was there.
 *
 * @param line from 1
 * @param executions how often it was executed
 * @param frames how many frames that took together; a paused program takes none
 * @param longestFrames how many the longest execution took
 * @param pathM way of the tool centre point, m
 * @param toolSpeedMPerS highest speed of it, m/s
 * @param worst where the arm came nearest to its limits, in the order of the margins; none where
 *     there is no limit
 */
public record LineStatistics(
    int line,
    long executions,
    long frames,
    long longestFrames,
    double pathM,
    double toolSpeedMPerS,
    List<Worst> worst) {
  /** A shorter way is what rounding leaves of an arm at rest, m. */
  private static final double MIN_WAY_M = 1e-9;

  /** Copies the list. */
  public LineStatistics {
    worst = List.copyOf(worst);
  }

  /**
   * Both together, as of the lines of one step of a program: they count as one execution if both
   * were executed as often.
   */
  public LineStatistics and(LineStatistics other) {
    boolean together = executions == other.executions;
    return new LineStatistics(
        Math.min(line, other.line),
        Math.max(executions, other.executions),
        frames + other.frames,
        together
            ? longestFrames + other.longestFrames
            : Math.max(longestFrames, other.longestFrames),
        pathM + other.pathM,
        Math.max(toolSpeedMPerS, other.toolSpeedMPerS),
        Stream.of(Margin.values())
            .flatMap(each -> nearer(worst(each), other.worst(each)).stream())
            .toList());
  }

  private static Optional<Worst> nearer(Optional<Worst> one, Optional<Worst> other) {
    if (one.isEmpty() || other.isEmpty()) {
      return one.or(() -> other);
    }
    return one.get().margin().nearer(other.get().value(), one.get().value()) ? other : one;
  }

  /** How long it took in all, s. */
  public double timeS() {
    return frames * FrameTime.FRAME_S;
  }

  /** How long the longest execution took, s. */
  public double longestS() {
    return longestFrames * FrameTime.FRAME_S;
  }

  /** Whether the arm moved. */
  public boolean moved() {
    return pathM > MIN_WAY_M || worst(Margin.JOINT_SPEED).filter(w -> w.value() > 0).isPresent();
  }

  /** Where the arm came nearest to a limit. */
  public Optional<Worst> worst(Margin margin) {
    return worst.stream().filter(each -> each.margin() == margin).findFirst();
  }
}
