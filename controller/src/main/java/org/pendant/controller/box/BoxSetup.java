package org.pendant.controller.box;

import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.message.Operator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/**
 * What a control box is built with.
 *
 * @param arm the arm it drives
 * @param startRad where the joints are at first, rad
 * @param seed of the random numbers that programs ask for
 * @param operator who answers popups and questions
 * @param systemTime where the date comes from; without one it starts at {@link
 *     ControlBox#VIRTUAL_START} and goes with the frames, so that runs repeat exactly
 */
public record BoxSetup(
    ArmDescription arm,
    Joints startRad,
    long seed,
    Operator operator,
    Optional<InstantSource> systemTime) {
  /**
   * Where the arm stands when nothing else is said: forearm level, tool down, away from every
   * singularity, so that a program may begin with a linear move.
   */
  public static final Joints START_RAD =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);

  /**
   * Checks the start.
   *
   * @throws IllegalArgumentException if a joint is outside its range
   */
  public BoxSetup {
    if (!arm.withinLimits(startRad)) {
      throw new IllegalArgumentException(
          "start is " + startRad + ", must be within the joint ranges of " + arm.id());
    }
  }

  /**
   * A box without a screen, in virtual time.
   *
   * @param robotId an id of {@link ArmLibrary}
   */
  public static BoxSetup headless(String robotId) {
    return new BoxSetup(
        ArmLibrary.load(robotId), START_RAD, 0, Operator.headless(Map.of()), Optional.empty());
  }
}
