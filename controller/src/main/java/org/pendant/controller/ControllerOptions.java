package org.pendant.controller;

import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.message.Operator;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/**
 * How a controller is switched on.
 *
 * @param robotId the arm, an id of {@link ArmLibrary}
 * @param startRad where the joints are at first, rad
 * @param seed of the random numbers that programs ask for
 * @param operator who answers popups and questions
 * @param inputs levels of digital inputs by name, such as {@code digital_in[0]}; the others are low
 * @param systemTime where the date comes from; without one it starts at a fixed instant and goes
 *     with the frames, so that runs repeat exactly
 */
public record ControllerOptions(
    String robotId,
    Joints startRad,
    long seed,
    Operator operator,
    Map<String, Boolean> inputs,
    Optional<InstantSource> systemTime) {
  /** The arm when nothing else is said. */
  public static final String DEFAULT_ROBOT = "ur5e";

  /** Copies the map. */
  public ControllerOptions {
    inputs = Map.copyOf(inputs);
  }

  /** A UR5e in virtual time, without a screen: popups go on by themselves. */
  public static ControllerOptions headless() {
    return new ControllerOptions(
        DEFAULT_ROBOT,
        BoxSetup.START_RAD,
        0,
        Operator.headless(Map.of()),
        Map.of(),
        Optional.empty());
  }

  public ControllerOptions withRobot(String id) {
    return new ControllerOptions(id, startRad, seed, operator, inputs, systemTime);
  }

  public ControllerOptions withStart(Joints positionRad) {
    return new ControllerOptions(robotId, positionRad, seed, operator, inputs, systemTime);
  }

  public ControllerOptions withSeed(long number) {
    return new ControllerOptions(robotId, startRad, number, operator, inputs, systemTime);
  }

  public ControllerOptions withOperator(Operator person) {
    return new ControllerOptions(robotId, startRad, seed, person, inputs, systemTime);
  }

  public ControllerOptions withInputs(Map<String, Boolean> levels) {
    return new ControllerOptions(robotId, startRad, seed, operator, levels, systemTime);
  }

  /** The date is the one of {@code source}. */
  public ControllerOptions withSystemTime(InstantSource source) {
    return new ControllerOptions(robotId, startRad, seed, operator, inputs, Optional.of(source));
  }

  BoxSetup boxSetup() {
    return new BoxSetup(ArmLibrary.load(robotId), startRad, seed, operator, systemTime);
  }
}
