package org.pendant.controller.box;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.arm.ArmSupply;
import org.pendant.controller.arm.DynamicArm;
import org.pendant.controller.arm.IdealArm;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.controller.arm.SupplyMeter;
import org.pendant.controller.world.ArmNeighbours;
import org.pendant.controller.world.ArmSurroundings;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.LinkCollisions;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.collision.LinkCapsules;
import org.pendant.models.pose.Pose;

/**
 * Robot arm: the simulated one in its world, what the controller believes about it, how its base is
 * mounted, and the light ring there.
 */
public final class RobotArm {
  private final ArmDescription description;
  private final Scene scene;
  private final ArmModel model;
  private final ContactWorld world;
  private final List<LinkCollisions> collisions = new ArrayList<>();
  private final ArmNeighbours neighbours;

  /** Made when it is asked for: most runs never do. */
  private Optional<ArmSurroundings> surroundings = Optional.empty();

  private final SimulatedArm simulated;
  private final ArmSupply supply;
  private final SupplyMeter supplyMeter;
  private final FlangeForces forces;
  private BaseLight baseLight = BaseLight.STANDARD;

  RobotArm(BoxSetup setup) {
    description = setup.arm();
    scene = setup.scene();
    model = new ArmModel(description);
    world =
        setup
            .station()
            .map(CellStation::contacts)
            .orElseGet(() -> new ContactWorld(scene, () -> LinkCapsules.of(description)));
    neighbours =
        setup
            .station()
            .flatMap(CellStation::neighbours)
            .orElseGet(() -> ArmNeighbours.alone(description, scene));
    // nothing stops an ideal arm
    if (setup.armChoice() != ArmChoice.IDEAL) {
      LinkCollisions.of(description, scene).ifPresent(collisions::add);
      setup.station().flatMap(CellStation::encounters).ifPresent(collisions::add);
    }
    simulated = simulated(setup);
    supply = new ArmSupply(description);
    supplyMeter = new SupplyMeter(description, supply, setup.readingNoise(), setup.seed());
    forces = new FlangeForces(simulated, model);
  }

  private SimulatedArm simulated(BoxSetup setup) {
    DynamicArm.Setup own =
        new DynamicArm.Setup(
            setup.arm(),
            setup.startRad(),
            model.dynamics(),
            world,
            setup.readingNoise(),
            setup.seed());
    return switch (setup.armChoice()) {
      case IDEAL -> new IdealArm(own);
      case DYNAMIC -> new DynamicArm(own);
    };
  }

  /** What the arm is made of. */
  public ArmDescription description() {
    return description;
  }

  /** What the controller believes about masses, payload and mounting. */
  public ArmModel model() {
    return model;
  }

  /** The arm that follows. */
  public SimulatedArm simulated() {
    return simulated;
  }

  /** What the arm takes from its supply. */
  public ArmSupply supply() {
    return supply;
  }

  /** Reads the voltages and the current of the supply. */
  public SupplyMeter supplyMeter() {
    return supplyMeter;
  }

  /** What stands around the arm. */
  public Scene scene() {
    return scene;
  }

  /** What the arm may touch, and what pushes it. */
  public ContactWorld world() {
    return world;
  }

  /** What its links get into; empty where they pass through everything. */
  List<LinkCollisions> collisions() {
    return collisions;
  }

  /** The other arms of its cell. */
  public ArmNeighbours neighbours() {
    return neighbours;
  }

  /**
   * How near its links are to one another, to what stands around and to other arms; ask for the
   * nearest only. Any thread.
   */
  public synchronized ArmSurroundings surroundings() {
    if (surroundings.isEmpty()) {
      surroundings = Optional.of(neighbours.surroundings());
    }
    return surroundings.get();
  }

  /**
   * How near its links are to anything with the other arms where they are now, as {@link
   * ArmSurroundings#nearest} has it.
   */
  public double nearestM(Joints positionRad, Pose tcpInFlange) {
    double[] othersRad = new double[neighbours.numbers()];
    neighbours.read(othersRad);
    return surroundings().nearest(positionRad, tcpInFlange, othersRad).nearestM();
  }

  /** What is felt at the flange. */
  FlangeForces forces() {
    return forces;
  }

  /** The light ring in the base. */
  public BaseLight baseLight() {
    return baseLight;
  }

  /** Changes the light ring in the base. */
  public void setBaseLight(BaseLight light) {
    baseLight = light;
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
    simulated.setMounting(
        model.feltAccelerationMPerS2(0),
        model.feltAccelerationMPerS2(1),
        model.feltAccelerationMPerS2(2));
    simulated.modelChanged();
    forces.forget();
  }
}
