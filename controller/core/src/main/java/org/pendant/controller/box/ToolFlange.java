package org.pendant.controller.box;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.arm.ExternalForceSensor;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.controller.freedrive.Freedrive;
import org.pendant.controller.safety.SpeedCaps;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.LinkCollisions;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.models.pose.WrenchNumbers;
import org.pendant.motion.MotionControl;
import org.pendant.motion.force.ContactWatch;
import org.pendant.motion.force.ForceMode;

/**
 * Tool flange: what is mounted on it, what programs declare about that, and what is felt there. A
 * change of one reaches everything that goes by it.
 */
public final class ToolFlange {
  private final SimulatedArm arm;
  private final ContactWorld world;
  private final ArmModel model;
  private final FlangeForces forces;
  private final SpeedCaps speedCaps;
  private final MotionControl motion;
  private final Freedrive freedrive;
  private final ForceMode forceMode;
  private final ContactWatch contactWatch = new ContactWatch();
  private final List<LinkCollisions> collisions;
  private ToolCentre tool = ToolCentre.FLANGE;
  private final ToolWeightCheck weightCheck;
  private boolean cogAtTool;
  private boolean loadKnown;
  private boolean held;

  /**
   * A flange without a tool.
   *
   * @param arm on whose flange things hang
   * @param load what hangs on the flange at first; empty for what programs declare
   * @param weightCheck compares it with that
   * @param speedCaps hold limits at the TCP
   * @param motion carries the TCP
   * @param modes guide and press with what hangs there
   */
  ToolFlange(
      RobotArm arm,
      Optional<Payload> load,
      ToolWeightCheck weightCheck,
      SpeedCaps speedCaps,
      MotionControl motion,
      ControlModes modes) {
    this.arm = arm.simulated();
    collisions = arm.collisions();
    world = arm.world();
    model = arm.model();
    forces = arm.forces();
    this.weightCheck = weightCheck;
    this.speedCaps = speedCaps;
    this.motion = motion;
    freedrive = modes.freedrive();
    forceMode = modes.forceMode();
    loadKnown = load.isPresent();
    this.arm.setLoad(load.orElse(Payload.NONE));
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
    collisions.forEach(links -> links.setTool(tool.inFlange()));
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
    if (!held) {
      weightCheck.declared(payload);
    }
    if (!model.changing()) {
      payloadChanged();
      zeroForceSensor();
      freedrive.payloadChanged();
    }
  }

  /** Takes a declared payload one frame nearer; before the arm moves. */
  void stepTransition() {
    if (held != world.holdsBody()) {
      held = !held;
      payloadChanged();
    }
    if (model.changing()) {
      model.stepTransition();
      payloadChanged();
    }
  }

  /** Lets a payload hold that has come to its end; after the arm has moved. */
  void endTransition() {
    if (model.transitionEnded()) {
      zeroForceSensor();
      freedrive.payloadChanged();
    }
  }

  /**
   * Unless it has been said what truly hangs on the flange, it is what the program declares. What a
   * gripper holds comes on top: then it is what was declared before it was gripped.
   */
  private void payloadChanged() {
    if (!loadKnown && !held) {
      arm.setLoad(model.payload());
    }
    arm.modelChanged();
    forces.forget();
  }

  /** Hangs something on the flange, whatever programs declare. */
  public void attachLoad(Payload load) {
    loadKnown = true;
    arm.setLoad(load);
    forces.forget();
  }

  /** From now on what programs declare hangs on the flange. */
  public void followDeclaredPayload() {
    loadKnown = false;
    arm.setLoad(model.payload());
    forces.forget();
  }

  /** The arm has moved, or feels another gravity: what was felt no longer holds. */
  void armChanged() {
    forces.forget();
  }

  /** Makes what the force sensor feels now its zero (manual 18.72). */
  public void zeroForceSensor() {
    forces.zero();
    forceMode.sensorChanged();
    contactWatch.forget();
  }

  /** Notices when the tool meets something. */
  public ContactWatch contactWatch() {
    return contactWatch;
  }

  /**
   * The external wrench at the flange, along the axes of the base (manual 16.32); changes with the
   * next frame.
   */
  public WrenchNumbers wrenchInBase() {
    return forces.wrenchInBase();
  }

  /**
   * What the force sensor feels, with weights and without its zero, at the flange along its axes;
   * changes with the next frame.
   */
  public WrenchNumbers rawWrench() {
    return forces.rawWrench();
  }

  /**
   * Takes what an external force/torque sensor reads now.
   *
   * @param wrench on the tool at the point where it measures, N and Nm along the axes of the flange
   */
  public void readExternalForceSensor(Wrench wrench) {
    forces.externalSensor().read(wrench);
  }

  /** Has force control use an external sensor from now on (manual 18.2). */
  public void useExternalForceSensor(ExternalForceSensor.Attachment mounting) {
    forces.externalSensor().enable(mounting);
    forceMode.sensorChanged();
  }

  /** Has force control use the sensor in the flange again. */
  public void useOwnForceSensor() {
    forces.externalSensor().disable();
    forceMode.sensorChanged();
  }
}
