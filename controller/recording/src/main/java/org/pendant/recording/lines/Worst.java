package org.pendant.recording.lines;

import java.util.List;

/**
 * Worst moment: where an arm came nearest to a limit.
 *
 * @param value in the unit of the margin
 * @param part the joint, or the plane
 * @param frame when
 */
public record Worst(Margin margin, double value, String part, long frame) {
  static final List<String> JOINTS =
      List.of("base", "shoulder", "elbow", "wrist 1", "wrist 2", "wrist 3");

  /** How much of the margin is used up, 0 to 1. */
  public double used() {
    return margin.used(value);
  }
}
