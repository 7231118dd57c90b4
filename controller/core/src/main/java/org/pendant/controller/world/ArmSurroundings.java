package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.world.CellWorld.Standing;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.collision.ArmClearance;
import org.pendant.models.collision.Capsule;
import org.pendant.models.collision.LinkCapsules;
import org.pendant.models.collision.SolidShape;
import org.pendant.models.pose.Pose;

/**
 * Arm surroundings: what the links of an arm can get into in a scene: one another, the objects that
 * stand still, and, after these, the links of other arms. Tool points with a radius belong to the
 * arm, as its tool: they can get into links; what they do with objects is up to {@link
 * ContactWorld}.
 */
public final class ArmSurroundings implements LinkPairs {
  /** A tool that ends this near the flange is wrist 3 itself, m. */
  private static final double BARE_FLANGE_M = 0.02;

  private final ArmClearance clearance;

  /** Those with other arms; their pairs come after the others. */
  private final ArmEncounters encounters;

  private final double[] q = new double[Joints.COUNT];
  private final List<String> names;
  private final List<ToolPoint> toolPoints;

  /** The links of an arm in a scene. */
  public ArmSurroundings(ArmDescription arm, Scene scene) {
    this(new Standing("", arm, scene, Joints.ZERO, Pose.ZERO, true), List.of());
  }

  /**
   * The links of an arm in a cell.
   *
   * @param others the other arms there, at first with their joints where they start
   */
  public ArmSurroundings(Standing own, List<Standing> others) {
    ArmDescription arm = own.arm();
    Scene scene = own.scene();
    List<Capsule> capsules = capsules(arm, scene.toolPoints());
    List<SceneObject> still =
        scene.objects().stream()
            .filter(object -> object.massKg() == 0)
            .flatMap(object -> object.pieces().stream())
            .toList();
    toolPoints = scene.toolPoints();
    names = still.stream().map(SceneObject::name).toList();
    clearance =
        new ArmClearance(
            arm,
            capsules,
            capsules.isEmpty() ? List.of() : ToolBody.solids(scene.toolBodies()),
            still.stream().map(ArmSurroundings::solid).toList());
    encounters =
        new ArmEncounters(
            ArmEncounters.neighbour(own).links(),
            others.stream().map(ArmEncounters::neighbour).toList());
  }

  /** What an arm is made of, with those tool points that have a radius. */
  static List<Capsule> capsules(ArmDescription arm, List<ToolPoint> toolPoints) {
    List<Capsule> capsules = new ArrayList<>(LinkCapsules.of(arm));
    for (ToolPoint point : capsules.isEmpty() ? List.<ToolPoint>of() : toolPoints) {
      if (point.radiusM() > 0) {
        Vector3 at = point.pointInFlangeM();
        capsules.add(
            new Capsule(
                LinkCapsules.TOOL,
                at.x(),
                at.y(),
                at.z(),
                at.x(),
                at.y(),
                at.z(),
                point.radiusM()));
      }
    }
    return capsules;
  }

  /**
   * Moves the other arms.
   *
   * @param othersRad six joint positions of each, in their order, rad
   */
  public void moveOthers(double[] othersRad) {
    encounters.moveOthers(othersRad);
  }

  /**
   * Whether the tool is no longer than the flange: then it is wrist 3 that presses on things.
   *
   * @param tcpInFlange what the tool touches with, unless the scene says so
   */
  @Override
  public boolean bareFlange(Pose tcpInFlange) {
    if (toolPoints.isEmpty()) {
      Vector3 tcp = new Vector3(tcpInFlange.x(), tcpInFlange.y(), tcpInFlange.z());
      return tcp.length() < BARE_FLANGE_M;
    }
    return toolPoints.stream().allMatch(each -> each.pointInFlangeM().length() < BARE_FLANGE_M);
  }

  @Override
  public int pairs() {
    return clearance.pairs() + encounters.pairs();
  }

  @Override
  public void at(double[] positionRad) {
    clearance.at(positionRad);
    if (encounters.pairs() > 0) {
      encounters.at(positionRad);
    }
  }

  @Override
  public double travelM(double[] positionRad) {
    double ownM = clearance.travelM(positionRad);
    return encounters.pairs() > 0 ? Math.max(ownM, encounters.travelM(positionRad)) : ownM;
  }

  @Override
  public double distanceM(int pair, double farM) {
    return ofOthers(pair)
        ? encounters.distanceM(pair - clearance.pairs(), farM)
        : clearance.distanceM(pair, farM);
  }

  private boolean ofOthers(int pair) {
    return pair >= clearance.pairs();
  }

  private boolean farthest(int pair, double distanceM) {
    return !ofOthers(pair) && clearance.farthest(pair, distanceM);
  }

  /** Whether a pair is that of wrist 3 and an object, which touch where the flange presses. */
  @Override
  public boolean presses(int pair) {
    return !ofOthers(pair)
        && clearance.body(pair) == LinkCapsules.WRIST_3
        && clearance.obstacle(pair) >= 0;
  }

  /**
   * How far the two of the nearest pair are apart, and those of the nearest that is not of two
   * links of this arm: these are near to each other in postures that nothing is wrong with. Pairs
   * that are as far apart as they can be do not count, such as the shoulder and a floor below it.
   * No number for an arm of which no shape is known. Any thread may ask where nobody calls another
   * method.
   *
   * @param othersRad as {@link #moveOthers} takes it
   */
  public synchronized LinkDistances nearest(
      Joints positionRad, Pose tcpInFlange, double[] othersRad) {
    positionRad.copyTo(q);
    moveOthers(othersRad);
    at(q);
    boolean bare = bareFlange(tcpInFlange);
    double links = Double.POSITIVE_INFINITY;
    double objects = Double.POSITIVE_INFINITY;
    for (int pair = 0; pair < pairs(); pair++) {
      if (ofLinks(pair)) {
        links = Math.min(links, distanceM(pair, links));
      } else if (!bare || !presses(pair)) {
        double distanceM = distanceM(pair, objects);
        objects = farthest(pair, distanceM) ? objects : Math.min(objects, distanceM);
      }
    }
    return new LinkDistances(known(Math.min(links, objects)), known(objects));
  }

  private static double known(double leastM) {
    return leastM == Double.POSITIVE_INFINITY ? Double.NaN : leastM;
  }

  /** Whether the two of a pair are links of this arm. */
  private boolean ofLinks(int pair) {
    return !ofOthers(pair) && clearance.obstacle(pair) < 0;
  }

  /** The two of a pair, as one that overlaps by so much. */
  @Override
  public LinkHit hit(int pair, double depthM) {
    if (ofOthers(pair)) {
      return encounters.hit(pair - clearance.pairs(), depthM);
    }
    int body = clearance.body(pair);
    int obstacle = clearance.obstacle(pair);
    if (obstacle >= 0) {
      return new LinkHit(
          LinkCapsules.name(body),
          names.get(obstacle),
          true,
          Optional.empty(),
          jointOf(body),
          depthM);
    }
    int outer = clearance.otherBody(pair);
    return new LinkHit(
        LinkCapsules.name(outer),
        LinkCapsules.name(body),
        false,
        Optional.empty(),
        jointOf(outer),
        depthM);
  }

  static int jointOf(int body) {
    return Math.clamp(body, 1, LinkCapsules.WRIST_3) - 1;
  }

  /** An object of one piece as a solid, in the frame of its pose. */
  static SolidShape solid(SceneObject object) {
    return switch (object) {
      case SceneObject.Plane plane -> {
        Vector3 at = plane.pointInBaseM();
        Vector3 normal = plane.normalInBase();
        yield new SolidShape.HalfSpace(at.x(), at.y(), at.z(), normal.x(), normal.y(), normal.z());
      }
      case SceneObject.Box box -> {
        Vector3 size = box.sizeM();
        yield new SolidShape.Block(box.poseInBase(), size.x(), size.y(), size.z());
      }
      case SceneObject.Rod rod ->
          new SolidShape.Rod(rod.poseInBase(), rod.radiusM(), rod.lengthM(), rod.capsule());
      case SceneObject.Compound _ -> throw new IllegalArgumentException(text("severalPieces"));
      case SceneObject.Mesh mesh ->
          new SolidShape.Faces(mesh.poseInBase(), mesh.part().triangles());
      case SceneObject.Sphere ball -> {
        Vector3 at = ball.centreInBaseM();
        yield new SolidShape.Ball(at.x(), at.y(), at.z(), ball.radiusM());
      }
    };
  }
}
