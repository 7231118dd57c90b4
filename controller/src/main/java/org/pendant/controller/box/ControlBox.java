package org.pendant.controller.box;

import java.time.Instant;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.pendant.controller.arm.IdealArm;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.message.PopupBoard;
import org.pendant.controller.motion.FrameTime;
import org.pendant.controller.motion.MotionControl;
import org.pendant.controller.value.ScriptError;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;

/**
 * The mutable parts of a controller that built-in functions work on. The frame loop owns all of it;
 * no other thread may touch it.
 */
public final class ControlBox {
  /** Length of a frame, s. */
  public static final double FRAME_S = FrameTime.FRAME_S;

  /** The date at which a box in virtual time is switched on. */
  public static final Instant VIRTUAL_START = Instant.parse("2026-01-01T00:00:00Z");

  private static final long FRAME_NS = 1_000_000_000L / FrameTime.FRAMES_PER_SECOND;

  private final BoxSetup setup;
  private final ForwardKinematics forward;
  private final InverseKinematics inverse;
  private final Jacobian jacobian;
  private final MotionControl motion;
  private final SimulatedArm arm;
  private final DigitalIo io = new DigitalIo();
  private final MessageLog log = new MessageLog();
  private final PopupBoard popups;
  private final RandomGenerator random;
  private ToolCentre tool = ToolCentre.FLANGE;
  private long frame;

  /** A box that was just switched on, with an ideal arm. */
  public ControlBox(BoxSetup setup) {
    this.setup = setup;
    forward = new ForwardKinematics(setup.arm().dh());
    inverse = new InverseKinematics(setup.arm());
    jacobian = new Jacobian(setup.arm().dh());
    motion = new MotionControl(setup.arm(), setup.startRad());
    arm = new IdealArm(setup.startRad());
    popups = new PopupBoard(setup.operator());
    // not the service-loaded generators: looking one up costs more than a short program's run
    random = new SplittableRandom(setup.seed());
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

  /** The date and time of day. */
  public Instant systemTime() {
    return setup.systemTime().isPresent()
        ? setup.systemTime().get().instant()
        : VIRTUAL_START.plusNanos(timeNs());
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

  /** The motion under way and its target. */
  public MotionControl motion() {
    return motion;
  }

  /** The arm that follows. */
  public SimulatedArm arm() {
    return arm;
  }

  /** Digital inputs, outputs and flags. */
  public DigitalIo io() {
    return io;
  }

  /** The log. */
  public MessageLog log() {
    return log;
  }

  /** The popups on the screen. */
  public PopupBoard popups() {
    return popups;
  }

  /** Random numbers from the box's seed. */
  public RandomGenerator random() {
    return random;
  }

  /** The active tool centre point. */
  public ToolCentre tool() {
    return tool;
  }

  /** Changes the tool centre point; a move under way keeps the one it began with. */
  public void setTool(ToolCentre tool) {
    this.tool = tool;
  }

  /** Target pose of the TCP in the base frame. */
  public Pose targetTcpInBase() {
    return forward.tcpPose(motion.positionRad(), tool.inFlange());
  }

  /** Actual pose of the TCP in the base frame. */
  public Pose actualTcpInBase() {
    return forward.tcpPose(arm.positionRad(), tool.inFlange());
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

  /**
   * Puts the simulated arm elsewhere, at rest (manual 15.46).
   *
   * @throws ScriptError while it moves
   */
  public void jumpTo(Joints positionRad) throws ScriptError {
    motion.jumpTo(positionRad);
    arm.jumpTo(positionRad);
  }

  /** A program starts: clears what belongs to the one before. */
  public void programStarted() {
    motion.resume();
    motion.clearFault();
    log.programStarted();
    popups.closeBlocking();
  }
}
