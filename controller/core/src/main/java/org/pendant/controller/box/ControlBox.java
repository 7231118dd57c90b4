package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.device.CellDevices;
import org.pendant.controller.device.DeviceSurroundings;
import org.pendant.controller.device.EncoderLines;
import org.pendant.controller.device.ToolPlaces;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.message.OperatorPrompts;
import org.pendant.controller.safety.SafetySystem;
import org.pendant.controller.safety.SpeedCaps;
import org.pendant.controller.wire.SignalLines;
import org.pendant.motion.MotionControl;
import org.pendant.motion.toolpath.Toolpaths;
import org.pendant.script.function.Host;
import org.pendant.script.function.ScriptPlace;

/**
 * Control box: the mutable parts of a controller that built-in functions work on. The frame loop
 * owns all of it; no other thread may touch it.
 */
public final class ControlBox implements Host {
  private final BoxClock clock;
  private final MessageLog log = new MessageLog();
  private final Signals signals;
  private final RobotArm arm;
  private final SafetySystem safety;
  private final MotionControl motion;
  private final MotionOffsets offsets;
  private final MotionPlanning planning;
  private final ControlModes modes;
  private final ToolFlange flange;
  private final ArmDrive drive;
  private final ArmKinematics kinematics;
  private final BoxLinks links;
  private final OperatorPrompts prompts;
  private final ProgramEnvironment environment;

  /** A box that was just switched on. */
  public ControlBox(BoxSetup setup) {
    signals = setup.station().map(CellStation::signals).orElseGet(Signals::new);
    clock =
        new BoxClock(
            setup.systemTime(), new ExecutionTime(setup.readingNoise().measured(), setup.seed()));
    arm = new RobotArm(setup);
    safety =
        new SafetySystem(
            setup.arm(),
            arm.model().dynamics(),
            setup.safety(),
            log,
            setup.poweredOn(),
            setup.powerTimes());
    SpeedCaps speedCaps = new SpeedCaps(setup.arm(), arm.model().dynamics(), safety);
    motion = new MotionControl(setup.arm(), setup.startRad(), speedCaps);
    motion.setStartRamp(setup.startRamp());
    offsets = MotionOffsets.of(motion);
    planning =
        new MotionPlanning(
            new MotionSettings(setup.arm()),
            arm.model().pathLimits(),
            new Toolpaths(setup.arm(), setup.systemTime().isEmpty()));
    planning.limits().limitSpeeds(speedCaps);
    motion.limitRamps(planning.limits()::reachableScaling);
    modes = ControlModes.of(arm, safety, speedCaps, motion);
    flange =
        new ToolFlange(
            arm,
            setup.scene().mounted(),
            new ToolWeightCheck(setup.scene(), log::warning),
            speedCaps,
            motion,
            modes);
    drive =
        new ArmDrive(
            new ArmDrive.Setup(setup.startRad(), arm, safety, motion, modes, offsets, flange, log));
    kinematics = new ArmKinematics(setup.arm(), flange, motion, drive);
    links =
        new BoxLinks(
            setup.equipment(),
            new CellDevices(
                setup.equipment().devices(),
                signals,
                new DeviceSurroundings(arm.world(), tools(setup), encoders(setup), lines(setup)),
                log),
            DeterminismGuard.of(setup.connectors(), clock.determinism()),
            signals,
            log);
    prompts = OperatorPrompts.none(setup.operator(), log);
    environment = new ProgramEnvironment(setup.programsFolder(), setup.seed());
  }

  /** Where tools are: its own, or those of all arms in the cell. */
  private ToolPlaces tools(BoxSetup setup) {
    ToolPlaces all = setup.station().map(CellStation::tools).orElseGet(ToolPlaces::new);
    if (setup.station().isEmpty() || !setup.station().get().armless()) {
      all.add(() -> arm.world().inCell(kinematics.actualTcpInBase()));
    }
    return all;
  }

  /**
   * What devices may be wired to. One that is alone may have a file of several controllers: the
   * signals of the others are there, and low.
   */
  private SignalLines lines(BoxSetup setup) {
    if (setup.station().isPresent()) {
      return setup.station().get().lines();
    }
    SignalLines lines = new SignalLines(signals.digital());
    List<String> controllers = setup.equipment().controllers();
    for (int i = 0; i < controllers.size(); i++) {
      lines.add(controllers.get(i), i == 0 ? signals.digital() : new DigitalIo());
    }
    if (controllers.size() > 1) {
      log.warning(text("worksAlone", String.join(", ", controllers), controllers.getFirst()));
    }
    return lines;
  }

  /** What belts turn: its own encoders, or those of all controllers in the cell. */
  private EncoderLines encoders(BoxSetup setup) {
    EncoderLines all = setup.station().map(CellStation::encoders).orElseGet(EncoderLines::new);
    all.add((encoder, ticksPerS) -> offsets.encoders().get(encoder).run(ticksPerS));
    return all;
  }

  /** Begins the next frame. */
  public void beginFrame() {
    clock.beginFrame();
    log.setTime(clock.timeS());
  }

  /** The frame that is running, and the date. */
  public BoxClock clock() {
    return clock;
  }

  /** What joins the box to other computers and devices. */
  public BoxLinks links() {
    return links;
  }

  /** The arm, its model and the world around it. */
  public RobotArm arm() {
    return arm;
  }

  /** Where the arm and its tool are, and how they move. */
  public ArmKinematics kinematics() {
    return kinematics;
  }

  /** What hangs on the tool flange, and what is felt there. */
  public ToolFlange flange() {
    return flange;
  }

  /** How the arm follows what commands it. */
  public ArmDrive drive() {
    return drive;
  }

  /** The motion under way and its target. */
  public MotionControl motion() {
    return motion;
  }

  /** How moves are planned. */
  public MotionPlanning planning() {
    return planning;
  }

  /** What programs add to the path of their moves. */
  public MotionOffsets offsets() {
    return offsets;
  }

  /** Servoing, freedrive and force mode. */
  public ControlModes modes() {
    return modes;
  }

  /** Modes, limits and stops. */
  public SafetySystem safety() {
    return safety;
  }

  /** Every signal: digital and analog ones, registers, the tool connector. */
  public Signals signals() {
    return signals;
  }

  /** The log. */
  public MessageLog log() {
    return log;
  }

  /** The popups and questions for the operator. */
  public OperatorPrompts prompts() {
    return prompts;
  }

  /** The files and random numbers of programs. */
  public ProgramEnvironment environment() {
    return environment;
  }

  /** A program has ended, and with it what it expected of clients. */
  public void programStopped() {
    links.programStopped();
    flange.useOwnForceSensor();
  }

  /** A program starts: clears what belongs to the one before. */
  public void programStarted() {
    modes.freedrive().end();
    modes.forceMode().programStarted();
    motion.resume();
    motion.programStarted();
    offsets.path().reset();
    log.programStarted();
    planning.toolpaths().clear();
    prompts.popups().closeBlocking();
  }

  @Override
  public void warn(String message) {
    log.warning(message);
  }

  @Override
  public void internalError(Throwable fault) {
    log.internalError(fault);
  }

  @Override
  public void placeMessagesBy(Supplier<Optional<ScriptPlace>> place) {
    log.placeBy(place);
  }

  @Override
  public void programEnded() {
    links.outside().programEnded();
  }

  @Override
  public void pauseMotion() {
    motion.pause();
  }

  @Override
  public void resumeMotion() {
    motion.resume();
  }

  @Override
  public boolean arriving() {
    return motion.arriving();
  }

  @Override
  public boolean handsOverBeforeRest() {
    return motion.handsOverBeforeRest();
  }

  @Override
  public boolean wantsLookAhead() {
    return motion.wantsOutlook();
  }
}
