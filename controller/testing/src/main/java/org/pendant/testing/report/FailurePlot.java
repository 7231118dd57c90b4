package org.pendant.testing.report;

import java.util.List;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;

/**
 * Failure plot: joints and digital signals around the moment at which a test failed.
 *
 * @param momentS that moment, s of robot time
 * @param frames what was in each frame around it, oldest first
 */
public record FailurePlot(double momentS, List<Frame> frames) {
  /** How much is shown before the moment, s. */
  public static final double BEFORE_S = 2;

  /** How much is shown after it where the test went on, s. */
  public static final double AFTER_S = 0.5;

  public FailurePlot {
    frames = List.copyOf(frames);
  }

  /**
   * What was in one frame.
   *
   * @param timeS of robot time
   * @param positionRad joint positions
   * @param speedRadPerS joint speeds
   * @param levels of digital inputs and outputs
   */
  public record Frame(double timeS, Joints positionRad, Joints speedRadPerS, DigitalLevels levels) {
    /** What is in a frame. */
    public static Frame of(ControllerState state) {
      return new Frame(
          state.timeS(),
          state.arm().actualPositionRad(),
          state.arm().actualSpeedRadPerS(),
          state.io());
    }
  }

  /** Whether there is something to see: the arm moves, or a signal changes. */
  public boolean tells() {
    return frames.stream()
        .anyMatch(
            each ->
                !each.positionRad().equals(frames.getFirst().positionRad())
                    || !each.levels().equals(frames.getFirst().levels()));
  }
}
