package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.arm.ArmCommand;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.freedrive.Freedrive;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetySystem;
import org.pendant.controller.world.LinkCollisions;
import org.pendant.controller.world.LinkHit;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.motion.MotionControl;
import org.pendant.motion.PlanningException;
import org.pendant.motion.force.TaskDeviation;
import org.pendant.motion.servo.FrictionShare;
import org.pendant.motion.servo.TorqueSetpoint;
import org.pendant.script.value.ScriptError;

/**
 * Arm drive: lets the arm follow its control source, frame by frame, and makes the setpoint of the
 * motion and the arm agree again where no path joins them.
 */
public final class ArmDrive {
  private static final ArmCommand BACKDRIVEN =
      new ArmCommand.Torque(Joints.ZERO, FrictionShare.MOST);

  /** An arm that a stop leaves further than this from its target (rad) stays where it is. */
  private static final double ASIDE_RAD = 2e-3;

  /** The target of an arm on its brakes does not follow readings nearer than this, rad. */
  private static final double NOISE_RAD = 2e-4;

  private final Setup setup;
  private final SimulatedArm arm;
  private final SafetySystem safety;
  private final MotionControl motion;
  private final Freedrive freedrive;
  private ArmCommand.Torque torque = new ArmCommand.Torque(TorqueSetpoint.ZERO);
  private final DriveTarget driveTarget = new DriveTarget();
  private final PositionHistory history;
  private final List<LinkCollisions> collisions;
  private final double[] q = new double[Joints.COUNT];

  /** Where the joints are, as the encoders read them, rad. */
  private final JointNumbers actual = new JointNumbers();

  private final JointNumbers driven = new JointNumbers();

  /**
   * What commands the arm, and what looks at how it follows.
   *
   * @param startRad where the joints are at first, rad
   * @param arm the arm that follows
   * @param safety modes and stops
   * @param motion the target on a path
   * @param modes torques that programs stream, guiding by hand, and pressing with a force
   * @param offsets end when the arm was pushed off its path
   * @param flange what hangs on the arm; its contact watch sees what is felt there in each frame
   * @param log gets warnings
   */
  record Setup(
      Joints startRad,
      RobotArm arm,
      SafetySystem safety,
      MotionControl motion,
      ControlModes modes,
      MotionOffsets offsets,
      ToolFlange flange,
      MessageLog log) {}

  ArmDrive(Setup setup) {
    this.setup = setup;
    arm = setup.arm().simulated();
    safety = setup.safety();
    motion = setup.motion();
    freedrive = setup.modes().freedrive();
    collisions = setup.arm().collisions();
    actual.set(setup.startRad());
    history = new PositionHistory(setup.startRad());
  }

  /** Where the joints are, as the encoders read them, rad. */
  public Joints actualPositionRad() {
    return actual.joints();
  }

  /** As {@link #actualPositionRad}; allocates nothing. */
  public void readActualPositionRad(JointNumbers target) {
    target.set(actual);
  }

  /** Where the servos should hold the joints, rad: on the path, or beside it after a stop. */
  public Joints drivenPositionRad() {
    return driveTarget.positionRad(motion);
  }

  /** As {@link #drivenPositionRad}; changes when it is asked for again, and allocates nothing. */
  public JointNumbers drivenNow() {
    driveTarget.readPositionRad(motion, driven);
    return driven;
  }

  /** Where the joints were in the last frames. */
  public PositionHistory history() {
    return history;
  }

  /** Whether the arm has power, on its brakes or without them. */
  public boolean powered() {
    return safety.robotMode() != RobotMode.POWER_OFF;
  }

  /**
   * Refuses what moves the arm while it has no power or is on its brakes.
   *
   * @throws ScriptError that names the mode and what to do
   */
  public void requirePower() throws ScriptError {
    Optional<Refusal> refusal = safety.motionRefusal();
    if (refusal.isPresent()) {
      throw new ScriptError("power-off", refusal.get().text());
    }
  }

  /** Moves the arm by one frame; step 4. */
  public void step() {
    ToolFlange flange = setup.flange();
    flange.stepTransition();
    setup.arm().world().grip().beginFrame();
    arm.step(command());
    setup.arm().supply().step(arm.sensors(), powered());
    setup.arm().supplyMeter().step();
    flange.armChanged();
    arm.sensors().copyPositionRad(q);
    actual.update(q);
    history.add(q);
    flange.contactWatch().add(flange.wrenchInBase());
    watchForceMode();
    setup.arm().neighbours().say(q, arm.rests());
    watchLinks();
    if (freedrive.active()) {
      freedrive.follow(actual.joints(), arm.speedRadPerS());
    } else if (motion.torqueDriven()) {
      motion.guide(actual.joints(), arm.speedRadPerS());
    }
    flange.endTransition();
  }

  /** The command for a setpoint; the same one again while the setpoint stays. */
  private ArmCommand torque(TorqueSetpoint setpoint) {
    if (!torque.setpoint().equals(setpoint)) {
      torque = new ArmCommand.Torque(setpoint);
    }
    return torque;
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
          yield torque(setup.modes().servoing().torque());
        }
        if (driveTarget.beside() && safety.stop().isEmpty() && !motion.paused()) {
          driveTarget.stepBack();
        }
        yield driveTarget.servo(motion);
      }
      case BACKDRIVE -> BACKDRIVEN;
      default -> ArmCommand.BRAKES_ON;
    };
  }

  /** Tells the safety functions of an arm that was pushed too far aside for force mode. */
  private void watchForceMode() {
    Optional<TaskDeviation> aside = setup.modes().forceMode().deviation(drivenNow(), actual);
    if (aside.isPresent()) {
      safety.aside(aside.get());
    }
  }

  /** Tells the safety functions of a link that has got into something. */
  private void watchLinks() {
    if (collisions.isEmpty()) {
      return;
    }
    boolean undriven = safety.robotMode() != RobotMode.RUNNING || freedrive.active();
    boolean tolerated = undriven || motion.torqueDriven() || safety.stop().isPresent();
    for (int i = 0; i < collisions.size(); i++) {
      Optional<LinkHit> hit = collisions.get(i).look(q, tolerated);
      if (hit.isPresent()) {
        safety.linkHit(hit.get());
      }
    }
  }

  /** Lets target and arm agree where no path joins them; after the safety functions of a frame. */
  public void settle() {
    if (safety.robotMode() != RobotMode.RUNNING || safety.stop().isPresent()) {
      freedrive.end();
    }
    if (safety.robotMode() != RobotMode.RUNNING) {
      if (motion.moving() || motion.carried() || elsewhere()) {
        motion.adopt(actualPositionRad());
      }
      driveTarget.forget();
      return;
    }
    if (safety.stop().isPresent() && !motion.turning() && pushedAside()) {
      driveTarget.stayAt(actualPositionRad(), motion.positionRad());
    }
    if (driveTarget.beside() && !motion.moving()) {
      if (setup.offsets().conveyor().active() || setup.offsets().path().active()) {
        setup.log().warning(text("armPushed"));
      }
      setup.modes().forceMode().continueFrom(() -> motion.adopt(drivenPositionRad()));
      driveTarget.forget();
    }
  }

  /** Whether the arm is not where its target is, noise of the encoders left aside. */
  private boolean elsewhere() {
    return arm.rests()
        ? actualPositionRad().maxAbsDifference(motion.positionRad()) > NOISE_RAD
        : !motion.positionRad().equals(actualPositionRad());
  }

  private boolean pushedAside() {
    return !driveTarget.beside()
        && actualPositionRad().maxAbsDifference(motion.positionRad()) > ASIDE_RAD;
  }

  /**
   * Puts the simulated arm elsewhere, at rest (manual 15.46).
   *
   * @throws PlanningException while it moves
   */
  public void jumpTo(Joints positionRad) throws PlanningException {
    motion.jumpTo(positionRad);
    arm.jumpTo(positionRad);
    collisions.forEach(LinkCollisions::restart);
    safety.jumped();
    actual.set(positionRad);
    setup.flange().armChanged();
  }
}
