package org.pendant.command;

import org.pendant.controller.state.ControllerState;
import org.pendant.recording.compare.RunComparison;
import org.pendant.recording.compare.Samples;

/**
 * Sample collector: takes a sample of every frame of a run, until the arm has moved for as long as
 * it did in the recording.
 */
final class SampleCollector implements FrameWatcher {
  /** How much longer than the recording the run is watched, s. */
  private static final double AFTER_S = 3;

  /** How long a program may take until it moves the arm, s. */
  static final double MAX_WAIT_S = 60;

  private final Samples.Builder samples;
  private final double longestS;
  private double movedAtS = Double.NaN;
  private double lastS;
  private final double firstS;

  /**
   * @param start what there is before the program
   */
  SampleCollector(Samples recorded, ControllerState start) {
    samples = new Samples.Builder(RunComparison.needed(recorded));
    longestS = recorded.lastS() - recorded.firstS() + AFTER_S;
    firstS = start.timeS();
    see(start);
  }

  @Override
  public void see(ControllerState state) {
    samples.add(state);
    lastS = state.timeS();
    if (Double.isNaN(movedAtS) && state.arm().moving()) {
      movedAtS = lastS;
    }
  }

  /** Whether the arm has moved. */
  boolean moved() {
    return !Double.isNaN(movedAtS);
  }

  @Override
  public boolean enough() {
    return moved() ? lastS > movedAtS + longestS : lastS > firstS + MAX_WAIT_S;
  }

  /** All of them. */
  Samples samples() {
    return samples.build();
  }
}
