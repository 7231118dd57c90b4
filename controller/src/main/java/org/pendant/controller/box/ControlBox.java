package org.pendant.controller.box;

import java.time.Instant;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.pendant.controller.arm.ArmCommand;
import org.pendant.controller.arm.ArmSupply;
import org.pendant.controller.arm.DynamicArm;
import org.pendant.controller.arm.ExternalForceSensor;
import org.pendant.controller.arm.ForceSensor;
import org.pendant.controller.arm.IdealArm;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.controller.arm.WarmUp;
import org.pendant.controller.eip.Assemblies;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.freedrive.Freedrive;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.InputWatchdogs;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.message.PopupBoard;
import org.pendant.controller.message.PromptNumbers;
import org.pendant.controller.message.QuestionBoard;
import org.pendant.controller.modbus.ModbusSignals;
import org.pendant.controller.motion.ArmHeadroom;
import org.pendant.controller.motion.FrameTime;
import org.pendant.controller.motion.MotionControl;
import org.pendant.controller.motion.force.ContactWatch;
import org.pendant.controller.motion.force.ForceMode;
import org.pendant.controller.motion.offset.ConveyorTracking;
import org.pendant.controller.motion.offset.PathOffsetting;
import org.pendant.controller.motion.servo.Servoing;
import org.pendant.controller.outside.OutsideLinks;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetySystem;
import org.pendant.controller.safety.SpeedCaps;
import org.pendant.controller.toolpath.Toolpaths;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * The mutable parts of a controller that built-in functions work on. The frame loop owns all of it;
 * no other thread may touch it.
 */
public final class ControlBox {
  /** Length of a frame, s. */
  public static final double FRAME_S = FrameTime.FRAME_S;

  /** The date at which a box in virtual time is switched on. */
  public static final Instant VIRTUAL_START = Instant.parse("2026-01-01T00:00:00Z");

  private static final ArmCommand BACKDRIVEN = new ArmCommand.Torque(Joints.ZERO, true);

  private static final long FRAME_NS = 1_000_000_000L / FrameTime.FRAMES_PER_SECOND;

  /** An arm that a stop leaves farther than this from its target (rad) stays where it is. */
  private static final double ASIDE_RAD = 2e-3;

  /** What the electronics in the tool flange take, A. */
  private static final double TOOL_ELECTRONICS_A = 0.08;

  private final BoxSetup setup;
  private final ForwardKinematics forward;
  private final InverseKinematics inverse;
  private final Jacobian jacobian;
  private final ArmModel model;
  private final ContactWorld world;
  private final SimulatedArm arm;
  private final ArmSupply supply;
  private final ForceSensor forceSensor = new ForceSensor();
  private final ExternalForceSensor externalForceSensor = new ExternalForceSensor();
  private final SpeedCaps speedCaps;
  private final MotionControl motion;
  private final MotionSettings motionSettings;
  private final Encoders encoders = new Encoders();
  private final ConveyorTracking conveyor = new ConveyorTracking();
  private final PathOffsetting pathOffset = new PathOffsetting();
  private final Servoing servoing;
  private final ArmHeadroom headroom;
  private final DriveTarget driveTarget = new DriveTarget();
  private final Freedrive freedrive;
  private final ForceMode forceMode;
  private final ContactWatch contactWatch = new ContactWatch();
  private final PositionHistory history;
  private final Toolpaths toolpaths;
  private final SafetySystem safety;
  private final Signals signals = new Signals();
  private final InputWatchdogs inputWatchdogs = new InputWatchdogs();
  private final Assemblies assemblies = new Assemblies();
  private final MessageLog log = new MessageLog();
  private final OutsideLinks outside;
  private final ModbusSignals modbus;
  private final ToolLine toolLine;
  private final PopupBoard popups;
  private final QuestionBoard questions;
  private final RandomGenerator random;
  private ProgramsFolder programsFolder;
  private ToolCentre tool = ToolCentre.FLANGE;
  private Published published = Published.NOTHING;
  private boolean cogAtTool;
  private boolean loadKnown;
  private BaseLight baseLight = BaseLight.STANDARD;
  private Joints actualRad;
  private Wrench flangeWrench = Wrench.ZERO;

  /** Whether {@link #flangeWrench} is of the arm as it stands now. */
  private boolean wrenchKnown;

  private boolean shutDown;
  private long frame;

  /** A box that was just switched on. */
  public ControlBox(BoxSetup setup) {
    this.setup = setup;
    forward = new ForwardKinematics(setup.arm().dh());
    inverse = new InverseKinematics(setup.arm());
    jacobian = new Jacobian(setup.arm().dh());
    model = new ArmModel(setup.arm());
    world = new ContactWorld(setup.scene());
    arm = newArm();
    supply = new ArmSupply(setup.arm());
    loadKnown = setup.scene().load().isPresent();
    arm.setLoad(setup.scene().load().orElse(Payload.NONE));
    safety =
        new SafetySystem(
            setup.arm(),
            model.dynamics(),
            setup.safety(),
            log,
            setup.poweredOn(),
            setup.powerTimes());
    speedCaps = new SpeedCaps(setup.arm(), model.dynamics(), safety);
    motion = new MotionControl(setup.arm(), setup.startRad(), speedCaps);
    motion.addOffset(conveyor);
    motion.addOffset(pathOffset);
    motionSettings = new MotionSettings(setup.arm());
    toolpaths = new Toolpaths(setup.arm(), setup.systemTime().isEmpty());
    programsFolder = setup.programsFolder();
    servoing = new Servoing(setup.arm(), motion);
    headroom = new ArmHeadroom(setup.arm());
    motion.limitRamps(
        (last, own, before, wanted) -> headroom().reachableScaling(last, own, before, wanted));
    freedrive =
        new Freedrive(
            new Freedrive.Setup(
                setup.arm(),
                arm,
                model.dynamics(),
                model::payload,
                this::externalWrenchInBase,
                safety,
                speedCaps,
                motion));
    // after everything else that carries the tool
    forceMode =
        new ForceMode(
            new ForceMode.Setup(
                setup.arm(), arm, this::controlledWrenchInBase, speedCaps, safety::limits, motion));
    actualRad = setup.startRad();
    history = new PositionHistory(actualRad);
    outside = new OutsideLinks(setup.doors());
    modbus = new ModbusSignals(setup.doors().modbus(), log);
    signals.runState().lead(modbus::follow);
    toolLine = new ToolLine(setup.doors().toolSerial(), signals, log);
    PromptNumbers numbers = new PromptNumbers();
    popups = new PopupBoard(setup.operator(), log, numbers);
    questions = new QuestionBoard(setup.operator(), log, numbers);
    // not the service-loaded generators: looking one up costs more than a short program's run
    random = new SplittableRandom(setup.seed());
  }

  private SimulatedArm newArm() {
    DynamicArm.Setup own =
        new DynamicArm.Setup(
            setup.arm(),
            setup.startRad(),
            model.dynamics(),
            world,
            setup.encoderNoiseRad(),
            setup.seed());
    return switch (setup.armChoice()) {
      case IDEAL -> new IdealArm(own);
      case DYNAMIC -> new DynamicArm(own);
    };
  }

  /** Number of the frame that is running, from 1; 0 before the first. */
  public long frame() {
    return frame;
  }

  /** Begins the next frame. */
  public void beginFrame() {
    frame++;
    log.setTime(timeS());
  }

  /** Controller time at the end of the running frame, s since it was switched on. */
  public double timeS() {
    return frame / (double) FrameTime.FRAMES_PER_SECOND;
  }

  /** Controller time as {@link #timeS}, ns. */
  public long timeNs() {
    return frame * FRAME_NS;
  }

  /** The connections of programs to other computers. */
  public OutsideLinks outside() {
    return outside;
  }

  /** The Modbus signals that programs have added. */
  public ModbusSignals modbus() {
    return modbus;
  }

  /** The serial line of the tool connector. */
  public ToolLine toolLine() {
    return toolLine;
  }

  /** The date and time of day. */
  public Instant systemTime() {
    return setup.systemTime().isPresent()
        ? setup.systemTime().get().instant()
        : VIRTUAL_START.plusNanos(timeNs());
  }

  /** Whether the clock of the wall drives the frames, so that a run cannot be repeated exactly. */
  public boolean inRealTime() {
    return setup.systemTime().isPresent();
  }

  /** What the arm is made of. */
  public ArmDescription armDescription() {
    return setup.arm();
  }

  /** Forward kinematics of the arm. */
  public ForwardKinematics forward() {
    return forward;
  }

  /** Inverse kinematics of the arm. */
  public InverseKinematics inverse() {
    return inverse;
  }

  /** What the controller believes about masses, payload and mounting. */
  public ArmModel model() {
    return model;
  }

  /** What the arm may touch, and what pushes it. */
  public ContactWorld world() {
    return world;
  }

  /** Modes, limits and stops. */
  public SafetySystem safety() {
    return safety;
  }

  /** Where the joints were in the last frames. */
  public PositionHistory history() {
    return history;
  }

  /** The Jacobian of the arm; keeps scratch space, so only for the frame loop. */
  public Jacobian jacobian() {
    return jacobian;
  }

  /** The motion under way and its target. */
  public MotionControl motion() {
    return motion;
  }

  /** Guiding the arm by hand. */
  public Freedrive freedrive() {
    return freedrive;
  }

  /** Pressing with a force. */
  public ForceMode forceMode() {
    return forceMode;
  }

  /** Notices when the tool meets something. */
  public ContactWatch contactWatch() {
    return contactWatch;
  }

  /** What the arm can do with the payload and the mounting of now. */
  public ArmHeadroom headroom() {
    headroom.setPayload(model.payload());
    headroom.setGravity(
        model.feltAccelerationMPerS2(0),
        model.feltAccelerationMPerS2(1),
        model.feltAccelerationMPerS2(2));
    return headroom;
  }

  /** What stands around the arm. */
  public Scene scene() {
    return setup.scene();
  }

  /** The encoders of conveyors. */
  public Encoders encoders() {
    return encoders;
  }

  /** The conveyor that the tool goes along with. */
  public ConveyorTracking conveyor() {
    return conveyor;
  }

  /** What a program lays over the path of its moves. */
  public PathOffsetting pathOffset() {
    return pathOffset;
  }

  /** Motions that a program queues, and toolpaths. */
  public Toolpaths toolpaths() {
    return toolpaths;
  }

  /** Where programs may read files. */
  public ProgramsFolder programsFolder() {
    return programsFolder;
  }

  /** From now on programs may read files elsewhere. */
  public void setProgramsFolder(ProgramsFolder folder) {
    programsFolder = folder;
  }

  /** How moves are planned. */
  public MotionSettings motionSettings() {
    return motionSettings;
  }

  /** Speeds, servos and torques that programs stream. */
  public Servoing servoing() {
    return servoing;
  }

  /** The arm that follows. */
  public SimulatedArm arm() {
    return arm;
  }

  /** Digital inputs, outputs and flags. */
  public DigitalIo io() {
    return signals.digital();
  }

  /** Every signal: digital and analog ones, registers, the tool connector. */
  public Signals signals() {
    return signals;
  }

  /** What the controller told the world at the end of the frame before. */
  public Published published() {
    return published;
  }

  /** From now on programs read there what the controller tells the world. */
  public void setPublished(Published source) {
    published = source;
  }

  /** The log. */
  public MessageLog log() {
    return log;
  }

  /** The popups on the screen. */
  public PopupBoard popups() {
    return popups;
  }

  /** The questions that wait for the operator. */
  public QuestionBoard questions() {
    return questions;
  }

  /** Random numbers from the box's seed. */
  public RandomGenerator random() {
    return random;
  }

  /** The active tool centre point. */
  public ToolCentre tool() {
    return tool;
  }

  /**
   * Changes the tool centre point; a move under way keeps the one it began with. A payload that was
   * declared without a centre of gravity moves with it (manual 16.49).
   */
  public void setTool(ToolCentre tool) {
    this.tool = tool;
    arm.setToolCentre(tool.inFlange());
    speedCaps.setTool(tool.inFlange());
    motion.setTool(tool.inFlange());
    freedrive.setTool(tool.inFlange());
    forceMode.setTool(tool.inFlange());
    if (cogAtTool) {
      declareAtTool(model.targetPayload().massKg());
    }
  }

  /**
   * Declares the payload; the force sensor is zeroed at once or at the end of the transition.
   *
   * @param transitionS how long it takes to change over, s; 0 for at once
   */
  public void declarePayload(Payload payload, double transitionS) {
    cogAtTool = false;
    declare(payload, transitionS);
  }

  /** Declares a payload whose centre of gravity stays at the active TCP, also at later ones. */
  public void declarePayloadAtTool(double massKg) {
    cogAtTool = true;
    declareAtTool(massKg);
  }

  private void declareAtTool(double massKg) {
    Pose at = tool.inFlange();
    declare(Payload.of(massKg, at.x(), at.y(), at.z()), 0);
  }

  private void declare(Payload payload, double transitionS) {
    model.declare(payload, transitionS);
    if (!model.changing()) {
      payloadChanged();
      zeroForceSensor();
      freedrive.payloadChanged();
    }
  }

  /** Unless somebody has said what truly hangs on the flange, it is what the program declares. */
  private void payloadChanged() {
    if (!loadKnown) {
      arm.setLoad(model.payload());
    }
    arm.modelChanged();
    wrenchKnown = false;
  }

  /** Hangs something on the flange, whatever programs declare. */
  public void attachLoad(Payload load) {
    loadKnown = true;
    arm.setLoad(load);
    wrenchKnown = false;
  }

  /** From now on what programs declare hangs on the flange. */
  public void followDeclaredPayload() {
    loadKnown = false;
    arm.setLoad(model.payload());
    wrenchKnown = false;
  }

  /** Sets the acceleration that the resting arm feels, along the axes of the base, m/s². */
  public void setGravity(double x, double y, double z) {
    model.setGravity(x, y, z);
    mount();
  }

  /** Sets the acceleration of the base, along its axes, m/s². */
  public void setBaseAcceleration(double x, double y, double z) {
    model.setBaseAcceleration(x, y, z);
    mount();
  }

  private void mount() {
    arm.setMounting(
        model.feltAccelerationMPerS2(0),
        model.feltAccelerationMPerS2(1),
        model.feltAccelerationMPerS2(2));
    arm.modelChanged();
    wrenchKnown = false;
  }

  /** Makes what the force sensor feels now its zero (manual 18.72). */
  public void zeroForceSensor() {
    forceSensor.zero(arm, model.payload());
    wrenchKnown = false;
    forceMode.sensorChanged();
    contactWatch.forget();
  }

  /** The external wrench at the flange, along the axes of the base (manual 16.32). */
  public Wrench flangeWrenchInBase() {
    if (!wrenchKnown) {
      flangeWrench = forceSensor.wrenchAtFlangeInBase(arm, model.payload());
      wrenchKnown = true;
    }
    return flangeWrench;
  }

  /**
   * What force control has to go by, as {@link #flangeWrenchInBase}: what an external sensor feels,
   * while there is one.
   */
  private Wrench controlledWrenchInBase() {
    return externalForceSensor.enabled() ? externalWrenchInBase() : flangeWrenchInBase();
  }

  /** What an external sensor feels, at the flange along the axes of the base; 0 without one. */
  private Wrench externalWrenchInBase() {
    return externalForceSensor.enabled()
        ? externalForceSensor.wrenchAtFlangeInBase(arm, model.payload())
        : Wrench.ZERO;
  }

  /** What an external force/torque sensor reads. */
  public ExternalForceSensor externalForceSensor() {
    return externalForceSensor;
  }

  /** Has force control use an external sensor from now on (manual 18.2). */
  public void useExternalForceSensor(ExternalForceSensor.Mounting mounting) {
    externalForceSensor.enable(mounting);
    forceMode.sensorChanged();
  }

  /** Has force control use the sensor in the flange again. */
  public void useOwnForceSensor() {
    externalForceSensor.disable();
    forceMode.sensorChanged();
  }

  /** Who watches that inputs are written often enough. */
  public InputWatchdogs inputWatchdogs() {
    return inputWatchdogs;
  }

  /** What programs exchange with an EtherNet/IP scanner. */
  public Assemblies assemblies() {
    return assemblies;
  }

  /** Whether the arm has power, on its brakes or without them. */
  public boolean drivePower() {
    return safety.robotMode() != RobotMode.POWER_OFF;
  }

  /**
   * Refuses what moves the arm while it has no power or is on its brakes.
   *
   * @throws ScriptError that names the mode and what to do
   */
  public void requirePower() throws ScriptError {
    Optional<String> refusal = safety.motionRefusal();
    if (refusal.isPresent()) {
      throw new ScriptError("power-off", refusal.get());
    }
  }

  /** The current that the tool takes, A. */
  public double toolCurrentA() {
    return drivePower()
        ? TOOL_ELECTRONICS_A + signals.tool().loadA(signals.digital().levels().toolOut())
        : 0;
  }

  /** What the arm takes from its supply. */
  public ArmSupply supply() {
    return supply;
  }

  /**
   * What the force sensor feels, with weights and without its zero, at the flange along its axes.
   */
  public Wrench rawFlangeWrench() {
    return forceSensor.felt();
  }

  /** The temperature inside the control box, degrees Celsius. */
  public double controllerTemperatureC() {
    return WarmUp.CONTROL_BOX.temperatureC(timeS());
  }

  /** The light ring in the base. */
  public BaseLight baseLight() {
    return baseLight;
  }

  /** Changes the light ring in the base. */
  public void setBaseLight(BaseLight light) {
    baseLight = light;
  }

  /** Switches arm and controller off (manual 16.42); whoever drives the frames sees it. */
  public void shutDown() {
    shutDown = true;
    safety.powerOff();
  }

  /** Whether a program has switched the controller off. */
  public boolean isShutDown() {
    return shutDown;
  }

  /** Where the joints are, as the encoders read them, rad. */
  public Joints actualPositionRad() {
    return actualRad;
  }

  /** Where the servos should hold the joints, rad: on the path, or beside it after a stop. */
  public Joints drivenPositionRad() {
    return driveTarget.positionRad(motion);
  }

  /** Target pose of the TCP in the base frame. */
  public Pose targetTcpInBase() {
    return forward.tcpPose(motion.positionRad(), tool.inFlange());
  }

  /** Actual pose of the TCP in the base frame. */
  public Pose actualTcpInBase() {
    return forward.tcpPose(actualRad, tool.inFlange());
  }

  /**
   * Velocity of the TCP in m/s and its angular velocity in rad/s, both along the axes of the base.
   *
   * @param positionRad joint positions
   * @param speedRadPerS joint speeds
   */
  public Pose tcpTwistInBase(Joints positionRad, Joints speedRadPerS) {
    double[] matrix = new double[Jacobian.SIZE];
    double[] twist = new double[Pose.SIZE];
    jacobian.at(positionRad.toArray(), tool.inFlange(), matrix);
    Jacobian.twist(matrix, speedRadPerS.toArray(), twist);
    return Pose.of(twist);
  }

  /** Moves the arm by one frame; step 4. */
  public void stepArm() {
    if (model.changing()) {
      model.stepTransition();
      payloadChanged();
    }
    world.grip().beginFrame();
    arm.step(command());
    supply.step(arm.sensors(), drivePower());
    wrenchKnown = false;
    Joints position = arm.positionRad();
    if (!position.equals(actualRad)) {
      actualRad = position;
    }
    history.add(actualRad);
    contactWatch.add(flangeWrenchInBase());
    if (freedrive.active()) {
      freedrive.follow(actualRad, arm.speedRadPerS());
    } else if (motion.torqueDriven()) {
      motion.guide(actualRad, arm.speedRadPerS());
    }
    if (model.transitionEnded()) {
      zeroForceSensor();
      freedrive.payloadChanged();
    }
  }

  private ArmCommand command() {
    return switch (safety.robotMode()) {
      case RUNNING -> {
        if (freedrive.active()) {
          driveTarget.forget();
          yield freedrive.command();
        }
        if (motion.torqueDriven()) {
          driveTarget.forget();
          yield servoing.torque();
        }
        if (driveTarget.beside() && safety.stop().isEmpty()) {
          driveTarget.stepBack();
        }
        yield driveTarget.servo(motion);
      }
      case BACKDRIVE -> BACKDRIVEN;
      default -> ArmCommand.BRAKES_ON;
    };
  }

  /** Lets target and arm agree where no path joins them; after the safety functions of a frame. */
  public void settle() {
    if (safety.robotMode() != RobotMode.RUNNING || safety.stop().isPresent()) {
      freedrive.end();
    }
    if (safety.robotMode() != RobotMode.RUNNING) {
      if (motion.moving() || motion.carried() || !motion.positionRad().equals(actualRad)) {
        motion.adopt(actualRad);
      }
      driveTarget.forget();
      return;
    }
    if (safety.stop().isPresent() && motion.speedRadPerS().equals(Joints.ZERO) && pushedAside()) {
      driveTarget.stayAt(actualRad, motion.positionRad());
    }
    if (driveTarget.beside() && !motion.moving()) {
      if (conveyor.active() || pathOffset.active()) {
        log.warning(
            "the arm was pushed aside while it was stopped: conveyor tracking and path offset have"
                + " ended");
      }
      forceMode.goOnFrom(() -> motion.adopt(drivenPositionRad()));
      driveTarget.forget();
    }
  }

  private boolean pushedAside() {
    return !driveTarget.beside() && actualRad.maxAbsDifference(motion.positionRad()) > ASIDE_RAD;
  }

  /**
   * Puts the simulated arm elsewhere, at rest (manual 15.46).
   *
   * @throws ScriptError while it moves
   */
  public void jumpTo(Joints positionRad) throws ScriptError {
    motion.jumpTo(positionRad);
    arm.jumpTo(positionRad);
    safety.jumped();
    actualRad = positionRad;
    wrenchKnown = false;
  }

  /** A program has ended, and with it what it expected of clients. */
  public void programStopped() {
    inputWatchdogs.clear();
    assemblies.programEnded();
    useOwnForceSensor();
  }

  /** A program starts: clears what belongs to the one before. */
  public void programStarted() {
    freedrive.end();
    forceMode.programStarted();
    motion.resume();
    motion.clearFault();
    pathOffset.reset();
    log.programStarted();
    toolpaths.clear();
    popups.closeBlocking();
  }
}
