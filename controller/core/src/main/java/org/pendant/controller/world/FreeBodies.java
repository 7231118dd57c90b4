package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyGuide;
import org.pendant.cell.BodyHinge;
import org.pendant.cell.BodyRail;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.json.Json;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Free bodies: the objects of a scene that have a mass, as they move among the others. {@link
 * ArmBodies} push them.
 */
final class FreeBodies {
  /** Most objects, each piece of them, and parts of the tool together. */
  private static final int MAX_BODIES = 200;

  private final RigidBodyWorld bodies;
  private final List<SceneObject> objects;

  /** Those of the arms that stand among them, the first of which they were made with. */
  private final List<ArmBodies> arms = new ArrayList<>();

  /** Numbers of the bodies that can move: objects with a mass, and copies of them. */
  private final List<Integer> movable = new ArrayList<>();

  /** By the number of a body: where its frame is in that of its object, where these differ. */
  private final Map<Integer, BodyFrame> frames = new HashMap<>();

  private final double[] body12 = new double[Transforms.SIZE];

  /** Grows whenever one comes or goes. */
  private long comings;

  private final BodyGrip grip = new BodyGrip(this);

  /**
   * The bodies of a scene.
   *
   * @param setups of the arms that stand among them, at least one
   * @throws IllegalArgumentException if there are too many, or if they overlap
   */
  FreeBodies(List<SceneObject> objects, List<ArmBodies.Setup> setups) {
    this.objects = objects;
    List<BodyDescription> all = new ArrayList<>();
    for (SceneObject object : objects) {
      if (object.massKg() > 0) {
        movable.add(all.size());
      }
      all.add(body(object, all.size()));
    }
    ArmBodies first = new ArmBodies(setups.getFirst());
    int firstPoint = all.size();
    all.addAll(first.toolDescriptions(0));
    int firstLink = all.size();
    int pieces = firstLink + objects.stream().mapToInt(each -> each.pieces().size() - 1).sum();
    if (pieces > MAX_BODIES) {
      throw new IllegalArgumentException(text("tooManyBodies", pieces, MAX_BODIES));
    }
    all.addAll(first.linkDescriptions(0));
    bodies = new RigidBodyWorld(all, 0, 0, -ArmDynamics.STANDARD_GRAVITY_M_PER_S2);
    first.added(bodies, firstPoint, firstLink);
    arms.add(first);
    for (ArmBodies.Setup setup : setups.subList(1, setups.size())) {
      add(new ArmBodies(setup));
    }
  }

  private void add(ArmBodies arm) {
    int firstPoint = bodies.size();
    arm.toolDescriptions(arms.size()).forEach(bodies::add);
    int firstLink = bodies.size();
    arm.linkDescriptions(arms.size()).forEach(bodies::add);
    arm.added(bodies, firstPoint, firstLink);
    arms.add(arm);
  }

  /** What an arm has among them, by its number in the order of the setups. */
  ArmBodies arm(int number) {
    return arms.get(number);
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
  static void require(List<SceneObject> objects, SceneTool tool) {
    var _ = new FreeBodies(objects, List.of(new ArmBodies.Setup(tool, List.of(), Pose.ZERO)));
  }

  /** Sets gravity, m/s², along the axes of the base. */
  void setGravity(double x, double y, double z) {
    bodies.setGravity(x, y, z);
  }

  /** Lets them move; arms have said before where they are. */
  void advance(double stepS) {
    grip.step(stepS);
    bodies.advance(stepS);
    for (int i = 0; i < arms.size(); i++) {
      arms.get(i).feel();
    }
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
          if (frames.containsKey(i)) {
            frames.put(parts[copy], frames.get(i));
          }
        }
        return Optional.of(new PartPool(this, parts));
      }
    }
    return Optional.empty();
  }

  /** What one sees of them. */
  SightLine sight() {
    return new SightLine(this, objects);
  }

  /** Puts an object that can move on a rail; empty where there is none of that name. */
  Optional<BodyGuide> rail(String name, BodyRail.Line line) {
    return movable(name).map(body -> bodies.rail(body, line));
  }

  /** Puts an object that can move on a hinge; empty where there is none of that name. */
  Optional<BodyGuide> hinge(String name, BodyHinge.Axis axis) {
    return movable(name).map(body -> bodies.hinge(body, axis));
  }

  /** The number of an object of the scene that can move. */
  private Optional<Integer> movable(String name) {
    for (int i = 0; i < objects.size(); i++) {
      if (objects.get(i).massKg() > 0 && objects.get(i).name().equals(name)) {
        return Optional.of(i);
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

  /**
   * Where all that can move is; of copies only those that are there.
   *
   * @param place in whose base frame
   */
  List<MovedObject> moved(ArmPlace place) {
    List<MovedObject> now = new ArrayList<>();
    double[] transform12 = new double[Transforms.SIZE];
    for (int i : movable) {
      boolean there = bodies.present(i);
      if (there || i < objects.size()) {
        pose(i, transform12);
        now.add(
            new MovedObject(
                bodies.description(i).name(), place.inBase(Transforms.toPose(transform12)), there));
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
    throw new IllegalArgumentException(text("noSuchBody", Json.quoted(name)));
  }

  RigidBodyWorld bodies() {
    return bodies;
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

  /** Whether one of them moves or is touched. */
  boolean move() {
    if (grip.holds()) {
      return true;
    }
    for (int i = 0; i < arms.size(); i++) {
      if (arms.get(i).busy()) {
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
    BodyFrame frame = frames.get(i);
    if (frame == null) {
      bodies.pose(i, transform12);
    } else {
      bodies.pose(i, body12);
      frame.toFile(body12, transform12);
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
      case SceneObject.Mesh mesh when mesh.massKg() == 0 ->
          BodyDescription.fixed(
              mesh.name(),
              new BodyShape.Faces(mesh.part().triangles()),
              mesh.poseInBase(),
              surface);
      case SceneObject.Mesh mesh ->
          balanced(mesh, new MeshBody(mesh.part().triangles()), number, surface);
      case SceneObject.Compound compound ->
          balanced(compound, new CompoundBody(compound), number, surface);
      case SceneObject.Box _, SceneObject.Rod _, SceneObject.Sphere _ -> {
        SolidBody body = SolidBody.of(object);
        yield body(object, body.shape(), body.inFrame(), surface);
      }
    };
  }

  /** The body of an object whose pose is not that of its centre of gravity. */
  private BodyDescription balanced(
      SceneObject object, BodyFrame frame, int number, BodySurface surface) {
    frames.put(number, frame);
    Pose centre = frame.ofFile(object.poseInBase());
    for (int axis = 0; axis < 3; axis++) {
      SceneRange.POSITION.require(
          object.name() + ": centre of gravity[" + axis + "]", centre.get(axis));
    }
    return body(object, frame.shape(), centre, surface);
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
