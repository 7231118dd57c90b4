package org.pendant.controller.box;

import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.pendant.controller.arm.ArmSupply;
import org.pendant.controller.arm.DynamicArm;
import org.pendant.controller.arm.IdealArm;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.controller.arm.WarmUp;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.freedrive.Freedrive;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.message.OpenPopups;
import org.pendant.controller.message.PromptNumbers;
import org.pendant.controller.message.PromptQueue;
import org.pendant.controller.safety.SafetySystem;
import org.pendant.controller.safety.SpeedCaps;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionControl;
import org.pendant.motion.TorquePathLimits;
import org.pendant.motion.force.ContactWatch;
import org.pendant.motion.force.ForceMode;
import org.pendant.motion.offset.ConveyorTracking;
import org.pendant.motion.offset.PathOffsetting;
import org.pendant.motion.servo.Servoing;
import org.pendant.motion.toolpath.Toolpaths;
import org.pendant.script.function.Host;
import org.pendant.script.function.ScriptPlace;

/**
 * Control box: the mutable parts of a controller that built-in functions work on. The frame loop
 * owns all of it; no other thread may touch it.
 */
public final class ControlBox implements Host {
  /** Length of a frame, s. */
  public static final double FRAME_S = FrameTime.FRAME_S;

  /** What the electronics in the tool flange take, A. */
  private static final double TOOL_ELECTRONICS_A = 0.08;

  private final BoxSetup setup;
  private final BoxClock clock;
  private final ForwardKinematics forward;
  private final InverseKinematics inverse;
  private final Jacobian jacobian;
  private final ArmModel model;
  private final ContactWorld world;
  private final SimulatedArm arm;
  private final ArmSupply supply;
  private final SpeedCaps speedCaps;
  private final MotionControl motion;
  private final MotionSettings motionSettings;
  private final Encoders encoders = new Encoders();
  private final ConveyorTracking conveyor = new ConveyorTracking();
  private final PathOffsetting pathOffset = new PathOffsetting();
  private final Servoing servoing;
  private final Freedrive freedrive;
  private final ForceMode forceMode;
  private final ContactWatch contactWatch = new ContactWatch();
  private final ToolFlange flange;
  private final ArmDrive drive;
  private final Toolpaths toolpaths;
  private final SafetySystem safety;
  private final Signals signals = new Signals();
  private final MessageLog log = new MessageLog();
  private final BoxLinks links;
  private final OpenPopups popups;
  private final PromptQueue questions;
  private final RandomGenerator random;
  private ProgramsFolder programsFolder;
  private BaseLight baseLight = BaseLight.STANDARD;
  private boolean shutDown;

  /** A box that was just switched on. */
  public ControlBox(BoxSetup setup) {
    this.setup = setup;
    clock = new BoxClock(setup.systemTime());
    forward = new ForwardKinematics(setup.arm().dh());
    inverse = new InverseKinematics(setup.arm());
    jacobian = new Jacobian(setup.arm().dh());
    model = new ArmModel(setup.arm());
    world = new ContactWorld(setup.scene());
    arm = newArm();
    supply = new ArmSupply(setup.arm());
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
    model.pathLimits().limitSpeeds(speedCaps);
    motion.limitRamps(model.pathLimits()::reachableScaling);
    FlangeForces forces = new FlangeForces(arm, model);
    freedrive =
        new Freedrive(
            new Freedrive.Setup(
                setup.arm(),
                arm,
                model.dynamics(),
                model::payload,
                forces::externalWrenchInBase,
                safety,
                speedCaps,
                motion));
    // after everything else that carries the tool
    forceMode =
        new ForceMode(
            new ForceMode.Setup(
                setup.arm(),
                arm,
                forces::controlledWrenchInBase,
                speedCaps,
                safety::limits,
                motion));
    flange =
        new ToolFlange(
            new ToolFlange.Setup(
                arm,
                model,
                setup.scene().load(),
                forces,
                speedCaps,
                motion,
                freedrive,
                forceMode,
                contactWatch));
    drive =
        new ArmDrive(
            new ArmDrive.Setup(
                setup.startRad(),
                arm,
                supply,
                world,
                safety,
                motion,
                servoing,
                freedrive,
                forceMode,
                conveyor,
                pathOffset,
                flange,
                contactWatch,
                log));
    links =
        new BoxLinks(DeterminismGuard.of(setup.connectors(), clock.determinism()), signals, log);
    PromptNumbers numbers = new PromptNumbers();
    popups = new OpenPopups(setup.operator(), log, numbers);
    questions = new PromptQueue(setup.operator(), log, numbers);
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

  /** What the arm is capable of with the current payload and mounting. */
  public TorquePathLimits pathLimits() {
    return model.pathLimits();
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

  /**
   * The computer could not keep up.
   *
   * @param behindS by how much robot time has fallen behind the wall clock, s
   */
  public void noteLostTime(double behindS) {
    if (clock.fellBehind(behindS)) {
      log.warning(
          String.format(
              Locale.ROOT,
              "robot time is %.2f s behind the wall clock: this computer could not keep up",
              behindS));
    }
  }

  /** Where the program that runs, or ran last, may read files. */
  public ProgramsFolder programsFolder() {
    return programsFolder;
  }

  /** A program that may read files there is about to run. */
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

  /** The log. */
  public MessageLog log() {
    return log;
  }

  /** The popups on the screen. */
  public OpenPopups popups() {
    return popups;
  }

  /** The questions that wait for the operator. */
  public PromptQueue questions() {
    return questions;
  }

  /** Random numbers from the box's seed. */
  public RandomGenerator random() {
    return random;
  }

  /** What hangs on the tool flange, and what is felt there. */
  public ToolFlange flange() {
    return flange;
  }

  /** How the arm follows what commands it. */
  public ArmDrive drive() {
    return drive;
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
    flange.armChanged();
  }

  /** The current that the tool takes, A. */
  public double toolCurrentA() {
    return drive.powered()
        ? TOOL_ELECTRONICS_A + signals.tool().loadA(signals.digital().levels().toolOut())
        : 0;
  }

  /** What the arm takes from its supply. */
  public ArmSupply supply() {
    return supply;
  }

  /** The temperature inside the control box, degrees Celsius. */
  public double controllerTemperatureC() {
    return WarmUp.CONTROL_BOX.temperatureC(clock.timeS());
  }

  /** The light ring in the base. */
  public BaseLight baseLight() {
    return baseLight;
  }

  /** Changes the light ring in the base. */
  public void setBaseLight(BaseLight light) {
    baseLight = light;
  }

  /** Switches arm and controller off (manual 16.42); the thread that drives the frames sees it. */
  public void shutDown() {
    shutDown = true;
    safety.powerOff();
  }

  /** Whether a program has switched the controller off. */
  public boolean isShutDown() {
    return shutDown;
  }

  /** Target pose of the TCP in the base frame. */
  public Pose targetTcpInBase() {
    return forward.tcpPose(motion.positionRad(), flange.tool().inFlange());
  }

  /** Actual pose of the TCP in the base frame. */
  public Pose actualTcpInBase() {
    return forward.tcpPose(drive.actualPositionRad(), flange.tool().inFlange());
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
    jacobian.at(positionRad.toArray(), flange.tool().inFlange(), matrix);
    Jacobian.twist(matrix, speedRadPerS.toArray(), twist);
    return Pose.of(twist);
  }

  /** A program has ended, and with it what it expected of clients. */
  public void programStopped() {
    links.programStopped();
    flange.useOwnForceSensor();
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
