package org.pendant.command.comparison;

import java.util.List;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.recording.compare.RunComparison;

/**
 * Compared run: a comparison and what was compared.
 *
 * @param recording the name of the recording
 * @param program the name of the program
 * @param robot id of the arm
 * @param payload what was declared, for people
 * @param comparison what came out
 * @param limits what was asked of it
 */
public record ComparedRun(
    String recording,
    String program,
    String robot,
    String payload,
    RunComparison comparison,
    List<Limit> limits) {

  /** Copies the list. */
  public ComparedRun {
    limits = List.copyOf(limits);
  }

  /**
   * A limit on a difference.
   *
   * @param name of the difference
   * @param most the largest size that keeps it
   * @param size how large it is
   */
  public record Limit(String name, double most, double size) {
    /** Whether it is kept. */
    public boolean kept() {
      return size <= most;
    }
  }

  /** Whether all limits are kept. */
  public boolean kept() {
    return limits.stream().allMatch(Limit::kept);
  }

  /** What there are charts of. */
  public List<StateQuantity> charts() {
    return comparison.recorded().quantities();
  }
}
