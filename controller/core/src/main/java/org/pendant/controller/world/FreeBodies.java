package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.collision.Capsule;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.json.Json;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Free bodies: the objects of a scene that have a mass, as they move among the others. The tool
 * points are balls that push them, and feel them.
 */
final class FreeBodies {
  /** A tool point without a radius is a ball of this one to them, m. */
  private static final double MIN_POINT_M = 0.002;

  /** Most objects and tool points together. */
  private static final int MAX_BODIES = 200;

  private final RigidBodyWorld bodies;
  private final List<SceneObject> objects;
  private final List<ToolPoint> points;
  private final LinkBodies links;
  private final int firstLink;

  /** Force and torque on the flange's origin, along the base's axes, in the latest step. */
  private final double[] felt6 = new double[6];

  /** Numbers of the bodies that can move: objects with a mass, and copies of them. */
  private final List<Integer> movable = new ArrayList<>();

  /** By the number of a body: what it is where it is a mesh. */
  private final Map<Integer, MeshBody> meshes = new HashMap<>();

  private final double[] body12 = new double[Transforms.SIZE];

  /** Grows whenever one comes or goes. */
  private long comings;

  private final List<Hand> hands = new ArrayList<>();
  private final BodyGrip grip = new BodyGrip(this);

  /** Numbers of the bodies of the tool: its points, and the fingers of hands. */
  private final List<Integer> tools = new ArrayList<>();

  private final double[] ball12 = new double[Transforms.SIZE];
  private final double[] ballTwist6 = new double[6];
  private final double[] ballWrench6 = new double[6];

  /**
   * The bodies of a scene.
   *
   * @param capsules of the links that push them
   * @throws IllegalArgumentException if there are too many, or if they overlap
   */
  FreeBodies(List<SceneObject> objects, List<ToolPoint> toolPoints, List<Capsule> capsules) {
    this.objects = objects;
    links = new LinkBodies(capsules);
    points = toolPoints.isEmpty() ? List.of(new ToolPoint(new Vector3(0, 0, 0), 0)) : toolPoints;
    List<BodyDescription> all = new ArrayList<>();
    for (SceneObject object : objects) {
      if (object.massKg() > 0) {
        movable.add(all.size());
      }
      all.add(body(object, all.size()));
    }
    for (int i = 0; i < points.size(); i++) {
      double radiusM = Math.max(MIN_POINT_M, points.get(i).radiusM());
      tools.add(all.size());
      // a line break is in no object's name
      all.add(
          BodyDescription.kinematic(
              "tool\n" + i,
              new BodyShape.Sphere(radiusM),
              Pose.ZERO,
              new BodySurface(Material.DEFAULT.friction(), 0, Material.STIFFNESS.most())));
    }
    firstLink = all.size();
    if (firstLink > MAX_BODIES) {
      throw new IllegalArgumentException(
          "bodies: are " + firstLink + ", may be at most " + MAX_BODIES);
    }
    all.addAll(links.descriptions());
    bodies = new RigidBodyWorld(all, 0, 0, -ArmDynamics.STANDARD_GRAVITY_M_PER_S2);
  }

  /** Whether any object of a scene has a mass. */
  static boolean any(List<SceneObject> objects) {
    return objects.stream().anyMatch(each -> each.massKg() > 0);
  }

  /**
   * Checks the bodies of a scene.
   *
   * @throws IllegalArgumentException if there are too many, or if they overlap
   */
  static void require(List<SceneObject> objects, List<ToolPoint> toolPoints) {
    var _ = new FreeBodies(objects, toolPoints, List.of());
  }

  /** Sets gravity, m/s², along the axes of the base. */
  void setGravity(double x, double y, double z) {
    bodies.setGravity(x, y, z);
  }

  /**
   * Says where the links of the arm are, and how they move.
   *
   * @param linkFrames Denavit-Hartenberg frames 1 to 6 in the base frame
   * @param qd joint speeds, rad/s
   */
  void moveLinks(double[][] linkFrames, double[] qd) {
    links.move(linkFrames, qd, bodies, firstLink);
  }

  /** Adds the torques that joints feel of what links push, Nm. */
  void addTorques(double[] torqueNm) {
    links.addTorques(torqueNm, bodies, firstLink);
  }

  /**
   * Lets them move.
   *
   * @param onlyTcp whether the tool centre point is what touches
   */
  void advance(
      double[] flange12,
      double[] tcpInFlange3,
      Pose tcpInFlange,
      boolean onlyTcp,
      double[] twist6,
      double stepS) {
    for (Hand hand : hands) {
      hand.place(flange12, tcpInFlange, twist6);
    }
    grip.step(stepS);
    for (int i = 0; i < points.size(); i++) {
      Vector3 at = points.get(i).pointInFlangeM();
      double x = onlyTcp ? tcpInFlange3[0] : at.x();
      double y = onlyTcp ? tcpInFlange3[1] : at.y();
      double z = onlyTcp ? tcpInFlange3[2] : at.z();
      System.arraycopy(flange12, 0, ball12, 0, 9);
      for (int row = 0; row < 3; row++) {
        double arm = flange12[3 * row] * x + flange12[3 * row + 1] * y + flange12[3 * row + 2] * z;
        ballTwist6[row] = arm;
        ball12[9 + row] = flange12[9 + row] + arm;
      }
      double armX = ballTwist6[0];
      double armY = ballTwist6[1];
      double armZ = ballTwist6[2];
      ballTwist6[0] = twist6[0] + twist6[4] * armZ - twist6[5] * armY;
      ballTwist6[1] = twist6[1] + twist6[5] * armX - twist6[3] * armZ;
      ballTwist6[2] = twist6[2] + twist6[3] * armY - twist6[4] * armX;
      System.arraycopy(twist6, 3, ballTwist6, 3, 3);
      bodies.moveKinematic(objects.size() + i, ball12, ballTwist6);
    }
    bodies.advance(stepS);
    feel(flange12, tcpInFlange3, onlyTcp);
  }

  private void feel(double[] flange12, double[] tcpInFlange3, boolean onlyTcp) {
    Arrays.fill(felt6, 0);
    for (int i = 0; i < points.size(); i++) {
      bodies.wrench(objects.size() + i, ballWrench6);
      Vector3 at = points.get(i).pointInFlangeM();
      double x = onlyTcp ? tcpInFlange3[0] : at.x();
      double y = onlyTcp ? tcpInFlange3[1] : at.y();
      double z = onlyTcp ? tcpInFlange3[2] : at.z();
      double armX = flange12[0] * x + flange12[1] * y + flange12[2] * z;
      double armY = flange12[3] * x + flange12[4] * y + flange12[5] * z;
      double armZ = flange12[6] * x + flange12[7] * y + flange12[8] * z;
      for (int k = 0; k < 6; k++) {
        felt6[k] += ballWrench6[k];
      }
      felt6[3] += armY * ballWrench6[2] - armZ * ballWrench6[1];
      felt6[4] += armZ * ballWrench6[0] - armX * ballWrench6[2];
      felt6[5] += armX * ballWrench6[1] - armY * ballWrench6[0];
    }
    for (int i = 0; i < hands.size(); i++) {
      hands.get(i).addWrench(flange12, felt6);
    }
  }

  /**
   * Fingers among the bodies. The tool centre point, which lies between them, touches none of these
   * any more where the scene names no tool points.
   */
  FingerHand fingers(HandSetup setup, HandSetup.Grip.Pads pads, double strokeM, boolean onlyTcp) {
    FingerHand hand = new FingerHand(setup, pads, strokeM, this);
    hands.add(hand);
    if (onlyTcp) {
      bodies.setPresent(objects.size(), false);
    }
    return hand;
  }

  /** A vacuum cup among the bodies. */
  CupHand cup(HandSetup setup, HandSetup.Grip.Cup cup) {
    CupHand hand = new CupHand(setup, cup, this);
    hands.add(hand);
    return hand;
  }

  /** The box of a name that stands still, as a belt; empty where there is none. */
  Optional<BeltSurface> belt(String name) {
    for (int i = 0; i < objects.size(); i++) {
      if (objects.get(i) instanceof SceneObject.Box box
          && box.massKg() == 0
          && box.name().equals(name)) {
        return Optional.of(new BeltSurface(bodies, i));
      }
    }
    return Optional.empty();
  }

  /** An object that can move, and copies of it that are away; empty where there is none. */
  Optional<PartPool> pool(String name, int count) {
    for (int i = 0; i < objects.size(); i++) {
      BodyDescription part = bodies.description(i);
      if (objects.get(i).massKg() > 0 && part.name().equals(name)) {
        int[] parts = new int[count];
        parts[0] = i;
        for (int copy = 1; copy < count; copy++) {
          parts[copy] =
              bodies.add(
                  BodyDescription.free(
                      name + MovedObject.COPY + (copy + 1),
                      part.shape(),
                      part.poseInBase(),
                      part.massKg(),
                      part.surface()));
          bodies.setPresent(parts[copy], false);
          movable.add(parts[copy]);
          if (meshes.containsKey(i)) {
            meshes.put(parts[copy], meshes.get(i));
          }
        }
        return Optional.of(new PartPool(this, parts));
      }
    }
    return Optional.empty();
  }

  boolean putBack(int body) {
    boolean there = bodies.putBack(body);
    comings += there ? 1 : 0;
    return there;
  }

  /** Takes away what nothing holds and has its middle in a box along the base's axes, m. */
  int takeAway(Vector3 min, Vector3 max) {
    int taken = 0;
    double[] at = new double[Transforms.SIZE];
    for (int i : movable) {
      bodies.pose(i, at);
      if (bodies.present(i)
          && !bodies.held(i)
          && at[9] >= min.x()
          && at[9] <= max.x()
          && at[10] >= min.y()
          && at[10] <= max.y()
          && at[11] >= min.z()
          && at[11] <= max.z()) {
        bodies.setPresent(i, false);
        comings++;
        taken++;
      }
    }
    return taken;
  }

  /** Grows whenever a body comes or goes. */
  long comings() {
    return comings;
  }

  /** Where all that can move is; of copies only those that are there. */
  List<MovedObject> moved() {
    List<MovedObject> now = new ArrayList<>();
    double[] transform12 = new double[Transforms.SIZE];
    for (int i : movable) {
      boolean there = bodies.present(i);
      if (there || i < objects.size()) {
        pose(i, transform12);
        now.add(
            new MovedObject(bodies.description(i).name(), Transforms.toPose(transform12), there));
      }
    }
    return now;
  }

  /** The hand of a person among them. */
  BodyGrip grip() {
    return grip;
  }

  /**
   * Number of the body of a name that can move and is there.
   *
   * @throws IllegalArgumentException if there is none
   */
  int there(String name) {
    for (int i : movable) {
      if (bodies.present(i) && bodies.description(i).name().equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException(
        "object is " + Json.quoted(name) + ", must be one with a mass that is in the cell");
  }

  /** Whether a hand holds something. */
  boolean anyHeld() {
    for (int i = 0; i < hands.size(); i++) {
      if (hands.get(i).holds()) {
        return true;
      }
    }
    return false;
  }

  RigidBodyWorld bodies() {
    return bodies;
  }

  /** Adds a body that is part of the tool; answers its number. */
  int addTool(BodyDescription tool) {
    int number = bodies.add(tool);
    tools.add(number);
    return number;
  }

  /** Numbers of all bodies that are part of the tool. */
  int[] tools() {
    return tools.stream().mapToInt(Integer::intValue).toArray();
  }

  /** Coefficient of friction of a body. */
  double friction(int body) {
    return bodies.description(body).surface().friction();
  }

  /** The objects with a mass that may be as near as that to a place of the base frame. */
  List<Integer> near(double[] place3, double withinM) {
    List<Integer> near = new ArrayList<>();
    for (int i : movable) {
      if (bodies.near(i, place3[0], place3[1], place3[2], withinM)) {
        near.add(i);
      }
    }
    return near;
  }

  /** The object with a mass that a ray enters first, -1 for none. */
  int firstAlong(double[] from3, double[] along3, double lengthM) {
    int first = -1;
    double least = lengthM;
    for (int i : movable) {
      if (bodies.near(i, from3[0], from3[1], from3[2], lengthM)) {
        double way = bodies.enters(i, from3, along3, lengthM);
        if (way <= least) {
          least = way;
          first = i;
        }
      }
    }
    return first;
  }

  /** Adds what the tool feels of them. */
  void addWrench(double[] wrench6) {
    for (int k = 0; k < 6; k++) {
      wrench6[k] += felt6[k];
    }
  }

  /** Whether one of them moves or is touched. */
  boolean move() {
    if (grip.holds()) {
      return true;
    }
    for (int i = 0; i < hands.size(); i++) {
      if (hands.get(i).busy()) {
        return true;
      }
    }
    for (int i = 0; i < movable.size(); i++) {
      if (!bodies.sleeping(movable.get(i))) {
        return true;
      }
    }
    return false;
  }

  /**
   * Where object {@code i} of the scene is, as {@link Transforms} has it: its centre, or the origin
   * of its file.
   */
  void pose(int i, double[] transform12) {
    MeshBody mesh = meshes.get(i);
    if (mesh == null) {
      bodies.pose(i, transform12);
    } else {
      bodies.pose(i, body12);
      mesh.toFile(body12, transform12);
    }
  }

  /** The body of the next object. */
  private BodyDescription body(SceneObject object, int number) {
    Material material = object.material();
    BodySurface surface =
        new BodySurface(material.friction(), material.restitution(), material.stiffnessNPerM());
    return switch (object) {
      case SceneObject.Plane plane ->
          BodyDescription.fixed(plane.name(), new BodyShape.HalfSpace(), standing(plane), surface);
      case SceneObject.Box box -> {
        Vector3 size = box.sizeM();
        yield body(box, new BodyShape.Box(size.x(), size.y(), size.z()), box.poseInBase(), surface);
      }
      case SceneObject.Rod rod ->
          body(
              rod,
              rod.capsule()
                  ? new BodyShape.Capsule(rod.radiusM(), rod.lengthM())
                  : new BodyShape.Cylinder(rod.radiusM(), rod.lengthM()),
              rod.poseInBase(),
              surface);
      case SceneObject.Mesh mesh when mesh.massKg() > 0 -> {
        MeshBody body = new MeshBody(mesh.part().triangles());
        meshes.put(number, body);
        Pose centre = body.ofFile(mesh.poseInBase());
        for (int axis = 0; axis < 3; axis++) {
          SceneRange.POSITION.require(
              mesh.name() + ": centre of gravity[" + axis + "]", centre.get(axis));
        }
        yield body(mesh, body.shape(), centre, surface);
      }
      case SceneObject.Mesh mesh ->
          BodyDescription.fixed(
              mesh.name(),
              new BodyShape.Faces(mesh.part().triangles()),
              mesh.poseInBase(),
              surface);
      case SceneObject.Sphere ball -> {
        Vector3 at = ball.centreInBaseM();
        yield body(
            ball,
            new BodyShape.Sphere(ball.radiusM()),
            new Pose(at.x(), at.y(), at.z(), 0, 0, 0),
            surface);
      }
    };
  }

  private static BodyDescription body(
      SceneObject object, BodyShape shape, Pose pose, BodySurface surface) {
    return object.massKg() > 0
        ? BodyDescription.free(object.name(), shape, pose, object.massKg(), surface)
        : BodyDescription.fixed(object.name(), shape, pose, surface);
  }

  /** The pose whose z is the plane's normal. */
  private static Pose standing(SceneObject.Plane plane) {
    Vector3 n = plane.normalInBase();
    Vector3 at = plane.pointInBaseM();
    double across = Math.hypot(n.x(), n.y());
    double angle = Math.atan2(across, n.z());
    double rx = across > 0 ? -n.y() / across * angle : angle;
    double ry = across > 0 ? n.x() / across * angle : 0;
    return new Pose(at.x(), at.y(), at.z(), rx, ry, 0);
  }
}
