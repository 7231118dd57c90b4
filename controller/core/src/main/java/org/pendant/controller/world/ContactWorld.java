package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.cell.BodyGuide;
import org.pendant.cell.BodyHinge;
import org.pendant.cell.BodyProbe;
import org.pendant.cell.BodyRail;
import org.pendant.models.collision.Capsule;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * Contact model: the forces on the tool, those of a scene that it touches and one applied by hand.
 * {@link #grip} is another hand, which may be anywhere on the arm.
 *
 * <p>Each tool point is a ball (of radius 0 mostly) without mass, rigid with the flange. Where it
 * is inside an object, the object's {@link Material} pushes it out along the surface's normal and
 * holds against its sliding; the force acts at the point's deepest place. Contacts do not know of
 * one another: a point inside two objects is pushed by both. Spinning on the spot meets no
 * friction, and only tool points touch, not the rest of the tool and the arm.
 *
 * <p>A point pressed deeper than half a thin object's thickness leaves it on the far side. See
 * {@link Surface.Block} for edges and corners.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class ContactWorld {
  /** Largest component of an applied wrench, N and Nm; no arm withstands a tenth of it. */
  static final Range APPLIED = new Range(-10_000, 10_000, "");

  private final List<SceneObject> objects;
  private final Surface[] surfaces;
  private final List<ToolPoint> toolPoints;

  /** The objects that can move; null where there are none. */
  private final FreeBodies free;

  /** What this arm has among them; null where there are none. */
  private final ArmBodies own;

  private final ArmPlace place;

  /** Whether other arms share these objects: then the cell lets them move. */
  private final boolean shared;

  private List<MovedObject> moved = List.of();
  private boolean moving;
  private long comings;
  private Pose tcpInFlange = Pose.ZERO;
  private final HandGrip grip = new HandGrip();
  private Wrench applied = Wrench.ZERO;

  /** Of the latest step, for each object: depth at the deepest point, m, at most 0 if untouched. */
  private final double[] depthM;

  /** Of the latest step: three components of force, N, for each object. */
  private final double[] forceN;

  private final double[] normal = new double[3];
  private double clearanceM = Double.POSITIVE_INFINITY;

  /** The forces of {@code scene} on a tool that has no arm. */
  public ContactWorld(Scene scene) {
    this(scene, List::of);
  }

  /**
   * The forces of {@code scene}.
   *
   * @param links what the links of the arm are made of, which push what has a mass where the scene
   *     has them solid
   */
  public ContactWorld(Scene scene, Supplier<List<Capsule>> links) {
    this(
        scene,
        FreeBodies.any(scene.objects())
            ? new FreeBodies(
                scene.objects(),
                List.of(new ArmBodies.Setup(scene.tool(), solid(scene, links), Pose.ZERO)))
            : null);
  }

  private ContactWorld(Scene scene, FreeBodies free) {
    this(scene, free, free == null ? null : free.arm(0), new ArmPlace(Pose.ZERO), false);
  }

  /**
   * The forces of {@code scene} on one of several arms.
   *
   * @param scene as it is seen from the base of the arm
   * @param free those that all arms push; null where nothing has a mass
   * @param own what this arm has among them; null for a controller without an arm
   * @param place where the arm stands
   */
  ContactWorld(Scene scene, FreeBodies free, ArmBodies own, ArmPlace place, boolean shared) {
    objects = scene.objects();
    toolPoints = scene.toolPoints();
    this.free = free;
    this.shared = shared;
    this.own = own;
    this.place = place;
    surfaces = new Surface[objects.size()];
    for (int i = 0; i < surfaces.length; i++) {
      surfaces[i] = Surface.of(objects.get(i));
    }
    depthM = new double[surfaces.length];
    forceN = new double[3 * surfaces.length];
    apply(scene.pushAtTcpInBase());
  }

  static List<Capsule> solid(Scene scene, Supplier<List<Capsule>> links) {
    return scene.links() == LinkContact.STOP ? links.get() : List.of();
  }

  /**
   * The load on the tool from outside. Allocates nothing.
   *
   * @param flange12 the flange in the base frame, as {@link org.pendant.models.pose.Transforms} has
   *     it
   * @param tcpInFlange3 the active tool centre point in the flange's frame, m; touches things
   *     unless the scene names tool points, and takes the applied wrench
   * @param flangeTwist6 velocity of the flange's origin, m/s, and angular velocity, rad/s, along
   *     the base's axes
   * @param wrench6 overwritten with force, N, and torque about the flange's origin, Nm, along the
   *     base's axes
   */
  public void wrench(
      double[] flange12, double[] tcpInFlange3, double[] flangeTwist6, double[] wrench6) {
    clearanceM = Double.POSITIVE_INFINITY;
    Arrays.fill(depthM, 0);
    Arrays.fill(forceN, 0);
    Arrays.fill(wrench6, 0, 6, 0);
    double tcpX = tcpInFlange3[0];
    double tcpY = tcpInFlange3[1];
    double tcpZ = tcpInFlange3[2];
    addApplied(flange12, tcpX, tcpY, tcpZ, wrench6);
    if (own != null) {
      own.addWrench(wrench6);
    }
    if (toolPoints.isEmpty()) {
      touch(flange12, tcpX, tcpY, tcpZ, 0, flangeTwist6, wrench6);
    }
    for (int i = 0; i < toolPoints.size(); i++) {
      ToolPoint point = toolPoints.get(i);
      Vector3 inFlange = point.pointInFlangeM();
      touch(
          flange12,
          inFlange.x(),
          inFlange.y(),
          inFlange.z(),
          point.radiusM(),
          flangeTwist6,
          wrench6);
    }
  }

  /**
   * Lets the objects that have a mass move among the others, pushed by the tool. What the tool
   * feels of them is in {@link #wrench} until the next step.
   *
   * @param stepS how long, s; the other parameters are those of {@link #wrench}
   */
  public void advance(
      double[] flange12, double[] tcpInFlange3, double[] flangeTwist6, double stepS) {
    if (own != null && !shared) {
      place(flange12, tcpInFlange3, flangeTwist6);
      free.advance(stepS);
    }
  }

  /**
   * Says where the tool will be before the objects of a cell of several arms move. The parameters
   * are those of {@link #wrench}.
   */
  public void place(double[] flange12, double[] tcpInFlange3, double[] flangeTwist6) {
    if (own != null) {
      own.move(flange12, tcpInFlange3, tcpInFlange, toolPoints.isEmpty(), flangeTwist6);
    }
  }

  /** Whether others let the objects move, after {@link #place} of all arms. */
  public boolean shared() {
    return shared;
  }

  /**
   * What objects that have a mass do to the tool since the latest step.
   *
   * @param wrench6 overwritten with force, N, and torque about the flange's origin, Nm, along the
   *     base's axes
   */
  public void bodyWrench(double[] wrench6) {
    Arrays.fill(wrench6, 0, 6, 0);
    if (own != null) {
      own.addWrench(wrench6);
    }
  }

  /** Whether there are objects that links can push. */
  public boolean hasFreeBodies() {
    return own != null;
  }

  /** A pose in the base frame of the arm as it is in the frame of the cell. */
  public Pose inCell(Pose inBase) {
    return place.inCell(inBase);
  }

  /** A pose in the frame of the cell as it is in the base frame of the arm. */
  public Pose inBase(Pose inCell) {
    return place.inBase(inCell);
  }

  /**
   * Says where the links of the arm are before {@link #advance}, and how they move.
   *
   * @param linkFrames Denavit-Hartenberg frames 1 to 6 in the base frame
   * @param qd joint speeds, rad/s
   */
  public void moveLinks(double[][] linkFrames, double[] qd) {
    if (own != null) {
      own.moveLinks(linkFrames, qd);
    }
  }

  /** Adds the torques that joints feel of the objects that links push, Nm. */
  public void addLinkTorques(double[] torqueNm) {
    if (own != null) {
      own.addTorques(torqueNm);
    }
  }

  /**
   * Carries an object with a mass by hand, for as long as this is repeated: at the latest every
   * {@link HandGrip#DEAD_MAN_S} of robot time.
   *
   * @param object its name, or that of a copy
   * @param pointInBaseM where the hand takes it, m; counts only when it does not hold it yet
   * @param placeInBaseM where that point shall go, m
   * @throws IllegalArgumentException if there is no such object, a gripper holds it, or a number is
   *     outside -100 to 100 m
   */
  public void carry(String object, Vector3 pointInBaseM, Vector3 placeInBaseM) {
    if (free == null) {
      throw new IllegalArgumentException(text("nothingMoves"));
    }
    free.grip().pull(object, place.inCell(pointInBaseM), place.inCell(placeInBaseM));
  }

  /** Ends {@link #carry}. */
  public void putDown() {
    if (free != null) {
      free.grip().letGo();
    }
  }

  /** Whether an object moves, or is held up by the tool. */
  public boolean bodiesMove() {
    return free != null && free.move();
  }

  /**
   * Fingers that grip objects with a mass.
   *
   * @param setup of pads
   * @param strokeM how far they open
   * @return empty where no object can move
   */
  public Optional<ParallelGripper> fingers(GripperSetup setup, double strokeM) {
    return own != null && setup.grip() instanceof GripperSetup.Grip.Pads pads
        ? Optional.of(own.take(new ParallelGripper(setup, pads, strokeM, own, free)))
        : Optional.empty();
  }

  /**
   * A vacuum cup that holds objects with a mass.
   *
   * @param setup of a cup
   * @return empty where no object can move
   */
  public Optional<VacuumGripper> cup(GripperSetup setup) {
    return own != null && setup.grip() instanceof GripperSetup.Grip.Cup cup
        ? Optional.of(own.take(new VacuumGripper(setup, cup, own, free)))
        : Optional.empty();
  }

  /**
   * Watches whether an object with a mass is within a ball that is swept along a line, m.
   *
   * @return empty where no object can move
   */
  public Optional<BodyProbe> watchLine(Vector3 from, Vector3 to, double radiusM) {
    return free == null
        ? Optional.empty()
        : Optional.of(free.bodies().watchLine(from.toArray(), to.toArray(), radiusM));
  }

  /**
   * Watches whether an object with a mass is within a box along the axes of the base, m.
   *
   * @return empty where no object can move
   */
  public Optional<BodyProbe> watchBox(Vector3 min, Vector3 max) {
    return free == null
        ? Optional.empty()
        : Optional.of(free.bodies().watchBox(min.toArray(), max.toArray()));
  }

  /** A box of a name that stands still, as a belt; empty where there is none, or nothing moves. */
  public Optional<BeltSurface> belt(String box) {
    return free == null ? Optional.empty() : free.belt(box);
  }

  /** What one sees of the objects that have a mass; empty where there are none. */
  public Optional<SightLine> sight() {
    return free == null ? Optional.empty() : Optional.of(free.sight());
  }

  /**
   * Puts an object that has a mass on a rail.
   *
   * @param line in the frame of the cell
   * @return empty where there is none of that name
   */
  public Optional<BodyGuide> rail(String object, BodyRail.Line line) {
    return free == null ? Optional.empty() : free.rail(object, line);
  }

  /**
   * Puts an object that has a mass on a hinge.
   *
   * @param axis in the frame of the cell
   * @return empty where there is none of that name
   */
  public Optional<BodyGuide> hinge(String object, BodyHinge.Axis axis) {
    return free == null ? Optional.empty() : free.hinge(object, axis);
  }

  /**
   * An object of a name that has a mass, and copies of it that are away.
   *
   * @param count how many there are together
   * @return empty where there is none
   */
  public Optional<PartPool> pool(String object, int count) {
    return free == null ? Optional.empty() : free.pool(object, count);
  }

  /** Takes away what nothing holds and has its middle in a box, m; answers how many. */
  public int takeAway(Vector3 min, Vector3 max) {
    return free == null ? 0 : free.takeAway(min, max);
  }

  /** Whether a gripper holds an object: its weight is on the flange besides the load. */
  public boolean holdsBody() {
    return own != null && own.holds();
  }

  /** Says where the active tool centre point is, in the flange's frame. */
  public void setToolCentre(Pose tcpInFlange) {
    this.tcpInFlange = tcpInFlange;
  }

  /**
   * Sets what bodies fall with, m/s^2, along the axes of the base. Those that several arms share
   * fall along the cell's -z, however one of the arms is mounted.
   */
  public void setGravity(double x, double y, double z) {
    if (free != null && !shared) {
      free.setGravity(x, y, z);
    }
  }

  /**
   * Where an object is now.
   *
   * @param object its place in the scene, from 0
   * @param transform12 overwritten with its pose in the base frame, as {@link
   *     org.pendant.models.pose.Transforms} has it
   * @return whether it can move; otherwise nothing is written
   */
  public boolean poseNow(int object, double[] transform12) {
    if (free == null || objects.get(object).massKg() == 0) {
      return false;
    }
    free.pose(object, transform12);
    place.takeToBase(transform12);
    return true;
  }

  /**
   * Where the objects that have a mass are now; the same list as before while none moves. Empty
   * where there are none.
   */
  public List<MovedObject> moved() {
    if (free != null && (moved.isEmpty() || free.move() || moving || comings != free.comings())) {
      // once more after the last has come to rest
      moving = free.move();
      comings = free.comings();
      moved = List.copyOf(free.moved(place));
    }
    return moved;
  }

  /**
   * Pushes at the tool centre point until told otherwise.
   *
   * @param atTcpInBase force, N, and torque about the tool centre point, Nm, along the base's axes,
   *     each -10,000 to 10,000: positive fz pushes the tool up
   * @throws IllegalArgumentException if a number is outside this range
   */
  public void apply(Wrench atTcpInBase) {
    APPLIED.require("applied fx", atTcpInBase.fx());
    APPLIED.require("applied fy", atTcpInBase.fy());
    APPLIED.require("applied fz", atTcpInBase.fz());
    APPLIED.require("applied mx", atTcpInBase.mx());
    APPLIED.require("applied my", atTcpInBase.my());
    APPLIED.require("applied mz", atTcpInBase.mz());
    applied = atTcpInBase;
  }

  /** Applies nothing any more. */
  public void release() {
    applied = Wrench.ZERO;
  }

  /** What {@link #apply} was told last: at the tool centre point, along the base's axes. */
  public Wrench applied() {
    return applied;
  }

  /** The hand that pushes or pulls the arm at any place of it, besides {@link #apply}. */
  public HandGrip grip() {
    return grip;
  }

  /** Whether there is nothing that could push the arm, wherever it is. */
  public boolean pushesNothing() {
    return surfaces.length == 0 && applied.equals(Wrench.ZERO) && !grip.holds();
  }

  /** Whether the tool touched anything when {@link #wrench} was asked last. */
  public boolean inContact() {
    return clearanceM < 0;
  }

  /**
   * How far the tool was from the nearest object when {@link #wrench} was asked last, m: below 0 by
   * the depth where it touched, infinite where there is nothing.
   */
  public double clearanceM() {
    return clearanceM;
  }

  /** What the tool touched when {@link #wrench} was asked last, in the scene's order. */
  public List<Contact> contacts() {
    List<Contact> contacts = new ArrayList<>();
    for (int i = 0; i < surfaces.length; i++) {
      if (depthM[i] > 0) {
        Vector3 force = new Vector3(forceN[3 * i], forceN[3 * i + 1], forceN[3 * i + 2]);
        contacts.add(new Contact(objects.get(i).name(), depthM[i], force.length()));
      }
    }
    return contacts;
  }

  private void addApplied(double[] flange, double x, double y, double z, double[] wrench) {
    wrench[3] += applied.mx();
    wrench[4] += applied.my();
    wrench[5] += applied.mz();
    addForce(
        turned(flange, 0, x, y, z),
        turned(flange, 1, x, y, z),
        turned(flange, 2, x, y, z),
        applied.fx(),
        applied.fy(),
        applied.fz(),
        wrench);
  }

  /** Adds the forces of all objects on one point of the tool, given in the flange's frame. */
  private void touch(
      double[] flange,
      double x,
      double y,
      double z,
      double radiusM,
      double[] twist,
      double[] wrench) {
    double armX = turned(flange, 0, x, y, z);
    double armY = turned(flange, 1, x, y, z);
    double armZ = turned(flange, 2, x, y, z);
    for (int i = 0; i < surfaces.length; i++) {
      if (objects.get(i).massKg() > 0) {
        continue;
      }
      double distanceM =
          surfaces[i].distanceM(flange[9] + armX, flange[10] + armY, flange[11] + armZ, normal);
      clearanceM = Math.min(clearanceM, distanceM - radiusM);
      if (distanceM < radiusM) {
        push(
            i,
            radiusM - distanceM,
            armX - radiusM * normal[0],
            armY - radiusM * normal[1],
            armZ - radiusM * normal[2],
            twist,
            wrench);
      }
    }
  }

  /**
   * Adds the force of one object, along {@link #normal}, on a place of the tool that is {@code
   * (armX, armY, armZ)} away from the flange's origin.
   */
  private void push(
      int object,
      double depth,
      double armX,
      double armY,
      double armZ,
      double[] twist,
      double[] wrench) {
    double vx = twist[0] + twist[4] * armZ - twist[5] * armY;
    double vy = twist[1] + twist[5] * armX - twist[3] * armZ;
    double vz = twist[2] + twist[3] * armY - twist[4] * armX;
    double leaving = vx * normal[0] + vy * normal[1] + vz * normal[2];
    double slidingX = vx - leaving * normal[0];
    double slidingY = vy - leaving * normal[1];
    double slidingZ = vz - leaving * normal[2];
    double sliding = Math.sqrt(slidingX * slidingX + slidingY * slidingY + slidingZ * slidingZ);
    Material material = objects.get(object).material();
    double out = material.normalForceN(depth, leaving);
    double drag = material.dragNSPerM(out, sliding);
    double fx = out * normal[0] - drag * slidingX;
    double fy = out * normal[1] - drag * slidingY;
    double fz = out * normal[2] - drag * slidingZ;
    depthM[object] = Math.max(depthM[object], depth);
    forceN[3 * object] += fx;
    forceN[3 * object + 1] += fy;
    forceN[3 * object + 2] += fz;
    addForce(armX, armY, armZ, fx, fy, fz, wrench);
  }

  /** Adds a force that acts {@code (armX, armY, armZ)} away from the flange's origin. */
  private static void addForce(
      double armX, double armY, double armZ, double fx, double fy, double fz, double[] wrench) {
    wrench[0] += fx;
    wrench[1] += fy;
    wrench[2] += fz;
    wrench[3] += armY * fz - armZ * fy;
    wrench[4] += armZ * fx - armX * fz;
    wrench[5] += armX * fy - armY * fx;
  }

  /** Component {@code row} of a vector of the flange's frame, along the base's axes. */
  private static double turned(double[] flange, int row, double x, double y, double z) {
    return flange[3 * row] * x + flange[3 * row + 1] * y + flange[3 * row + 2] * z;
  }
}
