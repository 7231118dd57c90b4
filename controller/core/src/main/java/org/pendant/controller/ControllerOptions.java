package org.pendant.controller;

import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.arm.ReadingNoise;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.CellStation;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.FittedSafety;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.Joints;

/**
 * Options with which a controller is switched on. Immutable: each {@code with} method answers
 * changed options and leaves these as they are.
 */
public final class ControllerOptions {
  /** The arm when nothing else is said. */
  public static final String DEFAULT_ROBOT = "ur5e";

  /** What the values of a program may take where the computer has that much, in bytes. */
  public static final long STANDARD_MEMORY_BYTES = 256_000_000;

  /** The part of the JVM's memory that values may take, since others need some as well. */
  public static final int SHARE_OF_HEAP = 3;

  private String robotId = DEFAULT_ROBOT;
  private Optional<ArmDescription> ownArm = Optional.empty();
  private Calibration calibration = Calibration.NONE;
  private Joints startRad = BoxSetup.START_RAD;
  private long seed;
  private Operator operator = Operator.headless(List.of());
  private Map<String, Boolean> inputs = Map.of();
  private List<SignalWrite> signals = List.of();
  private Map<Integer, Double> encoderTicksPerS = Map.of();
  private ArmChoice armChoice = ArmChoice.DYNAMIC;
  private ReadingNoise noise = ReadingNoise.NONE;
  private boolean startRamp;
  private Scene scene = Scene.EMPTY;
  private CellEquipment equipment = CellEquipment.NONE;
  private Optional<SafetyConfiguration> safety = Optional.empty();
  private boolean poweredOn = true;
  private PowerTimes powerTimes = PowerTimes.STANDARD;
  private Optional<InstantSource> systemTime = Optional.empty();
  private ProgramsFolder programsFolder = ProgramsFolder.NONE;
  private Connectors outside = Connectors.NONE;
  private Optional<Installation> installation = Optional.empty();
  private Optional<CellStation> station = Optional.empty();
  private long memoryBytes = standardMemoryBytes();

  private ControllerOptions() {}

  /**
   * A UR5e in virtual time, powered on, in an empty world and without a screen: popups close by
   * themselves. Its encoders are exact, and programs start without a ramp.
   */
  public static ControllerOptions headless() {
    return new ControllerOptions();
  }

  private ControllerOptions changed(Consumer<ControllerOptions> change) {
    ControllerOptions copy = new ControllerOptions();
    copy.robotId = robotId;
    copy.ownArm = ownArm;
    copy.calibration = calibration;
    copy.startRad = startRad;
    copy.seed = seed;
    copy.operator = operator;
    copy.inputs = inputs;
    copy.signals = signals;
    copy.encoderTicksPerS = encoderTicksPerS;
    copy.armChoice = armChoice;
    copy.noise = noise;
    copy.startRamp = startRamp;
    copy.scene = scene;
    copy.equipment = equipment;
    copy.safety = safety;
    copy.poweredOn = poweredOn;
    copy.powerTimes = powerTimes;
    copy.systemTime = systemTime;
    copy.programsFolder = programsFolder;
    copy.outside = outside;
    copy.installation = installation;
    copy.station = station;
    copy.memoryBytes = memoryBytes;
    change.accept(copy);
    return copy;
  }

  /** With another arm, an id of {@link ArmLibrary}; it is exactly as its model says. */
  public ControllerOptions withRobot(String id) {
    return changed(
        copy -> {
          copy.robotId = id;
          copy.ownArm = Optional.empty();
          copy.calibration = Calibration.NONE;
        });
  }

  /** With an arm whose numbers are its own; its id says which model it is one of. */
  public ControllerOptions withRobot(ArmDescription arm) {
    return changed(
        copy -> {
          copy.robotId = arm.id();
          copy.ownArm = Optional.of(arm);
          copy.calibration = Calibration.NONE;
        });
  }

  /**
   * With one arm of the model: what the controller believes about its kinematics, and what the arm
   * is.
   */
  public ControllerOptions withCalibration(Calibration ofArm) {
    return changed(copy -> copy.calibration = ofArm);
  }

  /**
   * With another limit on the memory of programs.
   *
   * @param bytes what the values of one program may take together, above 0; see {@link
   *     org.pendant.script.value.Value#sizeBytes}
   */
  public ControllerOptions withMemory(long bytes) {
    return changed(copy -> copy.memoryBytes = bytes);
  }

  /** {@link #STANDARD_MEMORY_BYTES}, or less in a small process. */
  public static long standardMemoryBytes() {
    return Math.min(STANDARD_MEMORY_BYTES, mostMemoryBytes());
  }

  /** What the values of a program may take at most in this process, bytes. */
  public static long mostMemoryBytes() {
    return Runtime.getRuntime().maxMemory() / SHARE_OF_HEAP;
  }

  long memoryBytes() {
    return memoryBytes;
  }

  /** With the joints somewhere else at first, rad. */
  public ControllerOptions withStart(Joints positionRad) {
    return changed(copy -> copy.startRad = positionRad);
  }

  /** Where the joints are at first, rad. */
  public Joints startRad() {
    return startRad;
  }

  /** With another seed of random numbers and noise. */
  public ControllerOptions withSeed(long number) {
    return changed(copy -> copy.seed = number);
  }

  /** The seed of random numbers and noise. */
  public long seed() {
    return seed;
  }

  /** With another source of answers to popups and questions. */
  public ControllerOptions withOperator(Operator person) {
    return changed(copy -> copy.operator = person);
  }

  /**
   * With levels of inputs by name, such as {@code digital_in[0]} or {@code safeguard_stop}; the
   * others are low.
   */
  public ControllerOptions withInputs(Map<String, Boolean> levels) {
    return changed(copy -> copy.inputs = Map.copyOf(levels));
  }

  /** With signals that are set from the start, in this order. */
  public ControllerOptions withSignals(List<SignalWrite> writes) {
    return changed(copy -> copy.signals = List.copyOf(writes));
  }

  /**
   * With simulated belts that turn encoders from the start.
   *
   * @param ticksPerS by the number of the encoder, 0 or 1; see {@link WorldCommand.RunEncoder}
   */
  public ControllerOptions withEncoders(Map<Integer, Double> ticksPerS) {
    return changed(copy -> copy.encoderTicksPerS = Map.copyOf(ticksPerS));
  }

  /** With another simulation of the arm. */
  public ControllerOptions withArm(ArmChoice choice) {
    return changed(copy -> copy.armChoice = choice);
  }

  /**
   * With readings that err at random as those of recorded arms do, or exact ones; those of {@link
   * ArmChoice#IDEAL} are always exact.
   */
  public ControllerOptions withMeasuredNoise(boolean wanted) {
    return changed(copy -> copy.noise = noise.withMeasured(wanted));
  }

  /**
   * With noise on each reading of a joint encoder, its standard deviation in rad, whatever {@link
   * #withMeasuredNoise} says; 0 for none.
   */
  public ControllerOptions withEncoderNoise(double standardDeviationRad) {
    return changed(copy -> copy.noise = noise.withPosition(standardDeviationRad));
  }

  /** With the start ramp of a real arm's programs, see docs/motion.md; without it at first. */
  public ControllerOptions withStartRamp(boolean on) {
    return changed(copy -> copy.startRamp = on);
  }

  /** Whether programs have a start ramp. */
  public boolean startRamp() {
    return startRamp;
  }

  /** With something around the arm and on its flange. */
  public ControllerOptions withScene(Scene surroundings) {
    return changed(copy -> copy.scene = surroundings);
  }

  /** With something around the arm that answers programs. */
  public ControllerOptions withEquipment(CellEquipment devicesAndRules) {
    return changed(copy -> copy.equipment = devicesAndRules);
  }

  /**
   * Set up as an installation says. Its safety limits hold unless {@link #withSafety} names others;
   * inputs, signals and encoders of these options come after it.
   *
   * @param setUp for the arm of these options, or for any
   */
  public ControllerOptions withInstallation(Installation setUp) {
    return changed(copy -> copy.installation = Optional.of(setUp));
  }

  /** With other limits and planes than those that are standard for the arm. */
  public ControllerOptions withSafety(SafetyConfiguration limits) {
    return changed(copy -> copy.safety = Optional.of(limits));
  }

  /** Whether the arm is powered and its brakes are released at first. */
  public ControllerOptions withPower(boolean on) {
    return changed(copy -> copy.poweredOn = on);
  }

  /** With other times for changes of power. */
  public ControllerOptions withPowerTimes(PowerTimes times) {
    return changed(copy -> copy.powerTimes = times);
  }

  /**
   * With the date of {@code source}; without one it starts at a fixed instant and goes with the
   * frames, so that runs repeat exactly.
   */
  public ControllerOptions withSystemTime(InstantSource source) {
    return changed(copy -> copy.systemTime = Optional.of(source));
  }

  /** With a folder from which programs may read files; without one they can read none. */
  public ControllerOptions withProgramsFolder(ProgramsFolder folder) {
    return changed(copy -> copy.programsFolder = folder);
  }

  /** With ways to other computers; without any, programs that want there fail. */
  public ControllerOptions withOutside(Connectors connectors) {
    return changed(copy -> copy.outside = connectors);
  }

  /** At a place in a cell that it shares with other controllers. */
  ControllerOptions withStation(CellStation place) {
    return changed(copy -> copy.station = Optional.of(place));
  }

  /** Which simulation of the arm. */
  ArmChoice armChoice() {
    return armChoice;
  }

  /** Id of the arm. */
  public String robotId() {
    return robotId;
  }

  /** The arm, its calibration included. */
  public ArmDescription arm() {
    return ownArm.orElseGet(() -> ArmLibrary.load(robotId)).withCalibration(calibration);
  }

  /** Limits and planes. */
  public SafetyConfiguration safety() {
    return safety.orElseGet(
        () -> {
          ArmDescription arm = arm();
          return installation
              .flatMap(Installation::safety)
              .map(wanted -> FittedSafety.of(wanted, arm).configuration())
              .orElseGet(() -> SafetyConfiguration.standard(arm));
        });
  }

  /** What the controller is set up as. */
  public Optional<Installation> installation() {
    return installation;
  }

  /** What is around the arm and on its flange. */
  public Scene scene() {
    return scene;
  }

  /** What around the arm answers programs. */
  public CellEquipment equipment() {
    return equipment;
  }

  /** By how much readings err. */
  public ReadingNoise noise() {
    return noise;
  }

  List<SignalWrite> signals() {
    return signals;
  }

  Map<Integer, Double> encoders() {
    return encoderTicksPerS;
  }

  Map<String, Boolean> inputs() {
    return inputs;
  }

  BoxSetup boxSetup() {
    return new BoxSetup(
        arm(),
        startRad,
        seed,
        operator,
        armChoice,
        noise,
        startRamp,
        scene,
        equipment,
        safety(),
        poweredOn,
        powerTimes,
        systemTime,
        programsFolder,
        outside,
        station);
  }
}
