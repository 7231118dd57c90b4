package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.arm.ReadingNoise;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/**
 * Setup of a control box: what it is built with.
 *
 * @param arm the arm it drives
 * @param startRad where the joints are at first, rad
 * @param seed of the random numbers that programs ask for
 * @param operator who answers popups and questions
 * @param armChoice which simulated arm
 * @param noise by how much readings err, but for those of an ideal arm
 * @param startRamp whether time on paths rises from 0 to 1 at the start of a program
 * @param scene what stands around the arm and hangs on it
 * @param equipment what around it answers programs
 * @param safety limits and planes
 * @param poweredOn whether the arm is powered and its brakes are released at first
 * @param powerTimes how long changes of power take
 * @param systemTime where the date comes from; without one it starts at {@link
 *     BoxClock#VIRTUAL_START} and goes with the frames, so that runs repeat exactly
 * @param programsFolder where programs may read files
 * @param connectors by which programs reach other computers
 * @param station its place in a cell that it shares with other controllers; empty for one that is
 *     alone in its cell
 */
public record BoxSetup(
    ArmDescription arm,
    Joints startRad,
    long seed,
    Operator operator,
    ArmChoice armChoice,
    ReadingNoise noise,
    boolean startRamp,
    Scene scene,
    CellEquipment equipment,
    SafetyConfiguration safety,
    boolean poweredOn,
    PowerTimes powerTimes,
    Optional<InstantSource> systemTime,
    ProgramsFolder programsFolder,
    Connectors connectors,
    Optional<CellStation> station) {
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
      throw new IllegalArgumentException(text("startOutOfRange", startRad, arm.id()));
    }
  }

  /** How readings err: an ideal arm has none that do. */
  ReadingNoise readingNoise() {
    return armChoice == ArmChoice.IDEAL ? ReadingNoise.NONE : noise;
  }

  /**
   * A powered box without a screen, in virtual time, with an ideal arm in an empty world.
   *
   * @param robotId an id of {@link ArmLibrary}
   */
  public static BoxSetup headless(String robotId) {
    ArmDescription arm = ArmLibrary.load(robotId);
    return new BoxSetup(
        arm,
        START_RAD,
        0,
        Operator.headless(List.of()),
        ArmChoice.IDEAL,
        ReadingNoise.NONE,
        false,
        Scene.EMPTY,
        CellEquipment.NONE,
        SafetyConfiguration.standard(arm),
        true,
        PowerTimes.STANDARD,
        Optional.empty(),
        ProgramsFolder.NONE,
        Connectors.NONE,
        Optional.empty());
  }
}
