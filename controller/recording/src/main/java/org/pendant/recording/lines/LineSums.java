package org.pendant.recording.lines;

import java.util.ArrayList;
import java.util.List;

/** Line sums: what has come together of one line so far. Mutable, and allocates nothing. */
final class LineSums {
  private static final List<Margin> MARGINS = List.of(Margin.values());

  private final double[] nearest = new double[MARGINS.size()];
  private final int[] parts = new int[MARGINS.size()];
  private final long[] when = new long[MARGINS.size()];
  private long executions;
  private long frames;
  private long longestFrames;
  private long executionFrames;
  private double pathM;
  private double toolSpeedMPerS;

  LineSums() {
    for (Margin each : MARGINS) {
      nearest[each.index()] = each.farthest();
    }
  }

  /** The line is executed once more. */
  void begin() {
    executions++;
    executionFrames = 0;
  }

  /** So many frames go by. */
  void passed(long count) {
    frames += count;
    executionFrames += count;
    longestFrames = Math.max(longestFrames, executionFrames);
  }

  /** The arm has moved to where it is in a frame, or stays there. */
  void add(FrameMargins now, long frame) {
    pathM += now.stepM();
    toolSpeedMPerS = Math.max(toolSpeedMPerS, now.toolSpeedMPerS());
    for (int i = 0; i < nearest.length; i++) {
      Margin margin = MARGINS.get(i);
      double value = now.value(margin);
      if (margin.nearer(value, nearest[i])) {
        nearest[i] = value;
        parts[i] = now.part(margin);
        when[i] = frame;
      }
    }
  }

  /**
   * What has come together.
   *
   * @param names who knows the parts of the arm
   */
  LineStatistics statistics(int line, FrameMargins names) {
    List<Worst> worst = new ArrayList<>();
    for (Margin each : MARGINS) {
      int i = each.index();
      if (nearest[i] != each.farthest()) {
        worst.add(new Worst(each, nearest[i], names.part(each, parts[i]), when[i]));
      }
    }
    return new LineStatistics(
        line, executions, frames, longestFrames, pathM, toolSpeedMPerS, worst);
  }
}
