package org.pendant.desktop.testwriter;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.io.SignalWrite;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Operated run: what a test is written from.
 *
 * @param startRad where the arm stood when the program started
 * @param tcpInFlange the TCP that was active then
 * @param speedFraction where the speed slider was then, 0 to 1
 * @param before what inputs, and outputs that were high, were set to then
 * @param steps in the order of their frames
 * @param left what happened and cannot be repeated by a test, in words
 */
public record OperatedRun(
    Joints startRad,
    Pose tcpInFlange,
    double speedFraction,
    List<SignalWrite> before,
    List<RunStep> steps,
    RunEnd end,
    List<String> left) {
  /** Copies the lists. */
  public OperatedRun {
    before = List.copyOf(before);
    steps = List.copyOf(steps);
    left = List.copyOf(left);
  }

  /** The same with something else that a test cannot repeat. */
  public OperatedRun withLeft(String words) {
    List<String> more = new ArrayList<>(left);
    more.add(words);
    return new OperatedRun(startRad, tcpInFlange, speedFraction, before, steps, end, more);
  }
}
