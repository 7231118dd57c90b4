package org.pendant.controller;

import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
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
 * @param armChoice which simulated arm
 * @param encoderNoiseRad standard deviation of each reading of a joint encoder, rad; 0 for exact
 * @param scene what stands around the arm and hangs on it
 * @param safety limits and planes; without them those that are standard for the arm
 * @param poweredOn whether the arm is powered and its brakes are released at first
 * @param systemTime where the date comes from; without one it starts at a fixed instant and goes
 *     with the frames, so that runs repeat exactly
 */
public record ControllerOptions(
    String robotId,
    Joints startRad,
    long seed,
    Operator operator,
    Map<String, Boolean> inputs,
    ArmChoice armChoice,
    double encoderNoiseRad,
    Scene scene,
    Optional<SafetyConfiguration> safety,
    boolean poweredOn,
    Optional<InstantSource> systemTime) {
  /** The arm when nothing else is said. */
  public static final String DEFAULT_ROBOT = "ur5e";

  /** Copies the map. */
  public ControllerOptions {
    inputs = Map.copyOf(inputs);
  }

  /**
   * A UR5e in virtual time, powered on, in an empty world and without a screen: popups go on by
   * themselves.
   */
  public static ControllerOptions headless() {
    return new ControllerOptions(
        DEFAULT_ROBOT,
        BoxSetup.START_RAD,
        0,
        Operator.headless(Map.of()),
        Map.of(),
        ArmChoice.DYNAMIC,
        0,
        Scene.EMPTY,
        Optional.empty(),
        true,
        Optional.empty());
  }

  public ControllerOptions withRobot(String id) {
    return new ControllerOptions(
        id,
        startRad,
        seed,
        operator,
        inputs,
        armChoice,
        encoderNoiseRad,
        scene,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withStart(Joints positionRad) {
    return new ControllerOptions(
        robotId,
        positionRad,
        seed,
        operator,
        inputs,
        armChoice,
        encoderNoiseRad,
        scene,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withSeed(long number) {
    return new ControllerOptions(
        robotId,
        startRad,
        number,
        operator,
        inputs,
        armChoice,
        encoderNoiseRad,
        scene,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withOperator(Operator person) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        person,
        inputs,
        armChoice,
        encoderNoiseRad,
        scene,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withInputs(Map<String, Boolean> levels) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        operator,
        levels,
        armChoice,
        encoderNoiseRad,
        scene,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withArm(ArmChoice choice) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        operator,
        inputs,
        choice,
        encoderNoiseRad,
        scene,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withEncoderNoise(double standardDeviationRad) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        operator,
        inputs,
        armChoice,
        standardDeviationRad,
        scene,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withScene(Scene surroundings) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        operator,
        inputs,
        armChoice,
        encoderNoiseRad,
        surroundings,
        safety,
        poweredOn,
        systemTime);
  }

  public ControllerOptions withSafety(SafetyConfiguration limits) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        operator,
        inputs,
        armChoice,
        encoderNoiseRad,
        scene,
        Optional.of(limits),
        poweredOn,
        systemTime);
  }

  /** Whether the arm is powered and its brakes are released at first. */
  public ControllerOptions withPower(boolean on) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        operator,
        inputs,
        armChoice,
        encoderNoiseRad,
        scene,
        safety,
        on,
        systemTime);
  }

  /** The date is the one of {@code source}. */
  public ControllerOptions withSystemTime(InstantSource source) {
    return new ControllerOptions(
        robotId,
        startRad,
        seed,
        operator,
        inputs,
        armChoice,
        encoderNoiseRad,
        scene,
        safety,
        poweredOn,
        Optional.of(source));
  }

  BoxSetup boxSetup() {
    ArmDescription arm = ArmLibrary.load(robotId);
    return new BoxSetup(
        arm,
        startRad,
        seed,
        operator,
        armChoice,
        encoderNoiseRad,
        scene,
        safety.orElseGet(() -> SafetyConfiguration.standard(arm)),
        poweredOn,
        systemTime);
  }
}
