package org.pendant.models.collision;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhParameters;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.mesh.SegmentDistance;
import org.pendant.models.pose.Transforms;

/**
 * Arm clearance: how far the bodies of an arm are from one another and from obstacles, pair by
 * pair.
 *
 * <p>Pairs are those of bodies that can touch and are not neighbours, then each moving body with
 * each obstacle: the arm stands on something, so the base has none. What is beyond the arm's reach
 * has no pairs either.
 *
 * <p>Mutable, for one thread; allocates nothing after it was made.
 */
public final class ArmClearance {
  private static final int BODIES = LinkCapsules.BODIES;

  /** The first joint is turned all round in so many steps to see how a distance changes. */
  private static final int TURN_STEPS = 72;

  /** In more of them than symmetry explains. */
  private static final int MANY_STEPS = TURN_STEPS / 8;

  /** Distances that differ by less are the same: those of solids are found to 1e-7 m. */
  private static final double UNCHANGED_M = 1e-6;

  private final ForwardKinematics forward;
  private final List<SolidShape> obstacles;
  private final List<ToolSolid> tool;
  private final double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
  private final double[] q = new double[Joints.COUNT];

  /** Ends of each capsule, six numbers each, in the frame of its body and in the base's. */
  private final double[] own;

  private final double[] ends;
  private final double[] radius;
  private final int[] body;

  /** The first capsule of each body, and one more: how many there are. */
  private final int[] start = new int[BODIES + 1];

  /** A ball around each body: its centre in the frame of the body and in the base's, and radius. */
  private final double[] ownCentre = new double[3 * BODIES];

  private final double[] centre = new double[3 * BODIES];
  private final double[] around = new double[BODIES];

  /** The two of each pair: a body, then a body or, after all of these, an obstacle. */
  private final int[] first;

  private final int[] second;

  /**
   * How far a pair is apart at most, m, where it is so wherever many joints are; infinite for
   * others.
   */
  private final double[] farthestM;

  /** How far each joint moves any point of the arm at most, m for each rad. */
  private final double[] leverM = new double[Joints.COUNT];

  /**
   * The bodies of an arm among obstacles, with all joints at 0.
   *
   * @param capsules what the bodies are made of, those of the tool included
   */
  public ArmClearance(ArmDescription arm, List<Capsule> capsules, List<SolidShape> obstacles) {
    this(arm, capsules, List.of(), obstacles);
  }

  /**
   * As the other, with a tool that has a shape of its own.
   *
   * @param tool solids on the flange, which meet obstacles, as its capsules do not
   */
  public ArmClearance(
      ArmDescription arm,
      List<Capsule> capsules,
      List<ToolSolid> tool,
      List<SolidShape> obstacles) {
    forward = new ForwardKinematics(arm);
    this.tool = List.copyOf(tool);
    this.obstacles = List.copyOf(obstacles);
    List<Capsule> sorted =
        capsules.stream().sorted(Comparator.comparingInt(Capsule::body)).toList();
    int count = sorted.size();
    own = new double[6 * count];
    ends = new double[6 * count];
    radius = new double[count];
    body = new int[count];
    for (int i = 0; i < count; i++) {
      Capsule capsule = sorted.get(i);
      double[] six = {
        capsule.ax(), capsule.ay(), capsule.az(), capsule.bx(), capsule.by(), capsule.bz()
      };
      System.arraycopy(six, 0, own, 6 * i, 6);
      radius[i] = capsule.radiusM();
      body[i] = capsule.body();
      start[capsule.body() + 1]++;
    }
    for (int i = 0; i < BODIES; i++) {
      start[i + 1] += start[i];
      surround(i);
    }
    reckonLevers(arm);
    List<int[]> pairs = pairs(arm.dh().d1());
    first = pairs.stream().mapToInt(pair -> pair[0]).toArray();
    second = pairs.stream().mapToInt(pair -> pair[1]).toArray();
    farthestM = farthest();
    at(new double[Joints.COUNT]);
  }

  private void surround(int of) {
    double[] least = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
    double[] most = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
    for (int i = 6 * start[of]; i < 6 * start[of + 1]; i++) {
      least[i % 3] = Math.min(least[i % 3], own[i]);
      most[i % 3] = Math.max(most[i % 3], own[i]);
    }
    for (int i = 0; i < 3 * solids(of); i++) {
      least[i % 3] = Math.min(least[i % 3], tool.get(i / 3).centre(i % 3));
      most[i % 3] = Math.max(most[i % 3], tool.get(i / 3).centre(i % 3));
    }
    for (int axis = 0; axis < 3 && has(of); axis++) {
      ownCentre[3 * of + axis] = (least[axis] + most[axis]) / 2;
    }
    around[of] = extent(of, ownCentre, 3 * of);
  }

  private int solids(int of) {
    return of == LinkCapsules.TOOL ? tool.size() : 0;
  }

  /** Whether a body has a shape. */
  boolean has(int of) {
    return start[of] < start[of + 1] || solids(of) > 0;
  }

  /** How far a body reaches from a place in its frame. */
  private double extent(int of, double[] from, int at) {
    double most = 0;
    for (int end = 2 * start[of]; end < 2 * start[of + 1]; end++) {
      double x = own[3 * end] - from[at];
      double y = own[3 * end + 1] - from[at + 1];
      double z = own[3 * end + 2] - from[at + 2];
      most = Math.max(most, Math.sqrt(x * x + y * y + z * z) + radius[end / 2]);
    }
    for (int i = 0; i < solids(of); i++) {
      most = Math.max(most, tool.get(i).extentM(from, at));
    }
    return most;
  }

  /** A joint moves nothing farther away than the links behind it are long together. */
  private void reckonLevers(ArmDescription arm) {
    DhParameters parameters = arm.dh().parameters();
    double[] origin = new double[3];
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      double lengthM = 0;
      for (int link = joint; link < Joints.COUNT; link++) {
        lengthM += Math.hypot(parameters.aM().get(link), parameters.dM().get(link));
        double extent = extent(link + 1, origin, 0);
        if (link == Joints.COUNT - 1) {
          extent = Math.max(extent, extent(LinkCapsules.TOOL, origin, 0));
        }
        leverM[joint] = Math.max(leverM[joint], lengthM + extent);
      }
    }
  }

  private List<int[]> pairs(double shoulderM) {
    List<int[]> pairs = new ArrayList<>();
    for (int one = 0; one < BODIES; one++) {
      for (int other = one + 1; other < BODIES; other++) {
        if (canTouch(one, other) && has(one) && has(other)) {
          pairs.add(new int[] {one, other});
        }
      }
    }
    for (int i = 0; i < obstacles.size(); i++) {
      for (int one = LinkCapsules.BASE + 1; one <= LinkCapsules.WRIST_3; one++) {
        if (has(one) && reaches(i, shoulderM)) {
          pairs.add(new int[] {one, BODIES + i});
        }
      }
      if (!tool.isEmpty() && reaches(i, shoulderM)) {
        pairs.add(new int[] {LinkCapsules.TOOL, BODIES + i});
      }
    }
    return pairs;
  }

  /**
   * How far shoulder and upper arm are from obstacles where that is as far as they can be in many
   * places of the joints. All are turned at once, each faster than the one before it.
   */
  private double[] farthest() {
    double[] mostM = new double[pairs()];
    int[] times = new int[pairs()];
    double[] turned = new double[Joints.COUNT];
    for (int i = 0; i < TURN_STEPS; i++) {
      for (int joint = 0; joint < Joints.COUNT; joint++) {
        turned[joint] = (joint + 1) * 2 * Math.PI * i / TURN_STEPS;
      }
      at(turned);
      for (int pair = 0; pair < pairs(); pair++) {
        if (obstacle(pair) >= 0 && first[pair] <= LinkCapsules.UPPER_ARM) {
          double distanceM = distanceM(pair, Double.POSITIVE_INFINITY);
          times[pair] =
              distanceM > mostM[pair] + UNCHANGED_M
                  ? 1
                  : distanceM > mostM[pair] - UNCHANGED_M ? times[pair] + 1 : times[pair];
          mostM[pair] = Math.max(mostM[pair], distanceM);
        }
      }
    }
    double[] farthest = new double[pairs()];
    Arrays.setAll(
        farthest,
        pair ->
            mostM[pair] > 0 && times[pair] > MANY_STEPS ? mostM[pair] : Double.POSITIVE_INFINITY);
    return farthest;
  }

  private boolean reaches(int obstacle, double shoulderM) {
    return obstacles.get(obstacle).toPoint(0, 0, shoulderM) <= leverM[0];
  }

  /** Whether two bodies can touch on any arm of this family, and are not neighbours. */
  static boolean canTouch(int one, int other) {
    if (other == LinkCapsules.TOOL) {
      // what is on the flange moves with wrist 3, so wrist 2 is its neighbour too
      return one < LinkCapsules.WRIST_3 - 1;
    }
    // whatever the joints: base and upper arm, forearm and wrist 2, wrist 1 and wrist 3
    boolean apart = other == one + 2 && (one == 0 || one == 3 || one == 4);
    return other >= one + 2 && !apart;
  }

  /** Takes six joint positions, rad. */
  public void at(double[] positionRad) {
    System.arraycopy(positionRad, 0, q, 0, Joints.COUNT);
    forward.frames(q, frames);
    for (int i = 0; i < radius.length; i++) {
      place(body[i], own, 6 * i, ends);
      place(body[i], own, 6 * i + 3, ends);
    }
    for (int i = 0; i < BODIES; i++) {
      place(i, ownCentre, 3 * i, centre);
    }
  }

  private void place(int of, double[] from, int at, double[] to) {
    if (of == LinkCapsules.BASE) {
      System.arraycopy(from, at, to, at, 3);
      return;
    }
    double[] frame = frames[Math.min(of, Joints.COUNT) - 1];
    double x = from[at];
    double y = from[at + 1];
    double z = from[at + 2];
    for (int row = 0; row < 3; row++) {
      to[at + row] =
          frame[9 + row] + frame[3 * row] * x + frame[3 * row + 1] * y + frame[3 * row + 2] * z;
    }
  }

  /** How far any of its points has moved at most from where it was put last, m. */
  public double travelM(double[] positionRad) {
    double sum = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      sum += Math.abs(positionRad[i] - q[i]) * leverM[i];
    }
    return sum;
  }

  /** How many pairs there are; they are numbered from 0. */
  public int pairs() {
    return first.length;
  }

  /**
   * Whether the two of a pair are as far apart as they can be, and are so in many places of the
   * joints: a shoulder that turns above a floor, an upper arm that points up from it. Nothing has
   * to be done about such a distance, however small it is.
   *
   * @param distanceM of the two where the arm is, m
   */
  public boolean farthest(int pair, double distanceM) {
    return distanceM > farthestM[pair] - UNCHANGED_M;
  }

  /** The body of a pair, or the one of two that is nearer the base. */
  public int body(int pair) {
    return first[pair];
  }

  /** The other body of a pair, which is nearer the flange; -1 where it is an obstacle. */
  public int otherBody(int pair) {
    return second[pair] < BODIES ? second[pair] : -1;
  }

  /** The obstacle of a pair, by its place in the list; -1 where it is a body. */
  public int obstacle(int pair) {
    return second[pair] - BODIES < 0 ? -1 : second[pair] - BODIES;
  }

  /**
   * How far the two of a pair are apart, m: below 0 by the depth where they overlap.
   *
   * @param farM from here on it need not be exact, m: the answer is then at least this, and at most
   *     the distance
   */
  public double distanceM(int pair, double farM) {
    return second[pair] < BODIES
        ? ofBodies(first[pair], second[pair], farM)
        : ofObstacle(first[pair], obstacles.get(second[pair] - BODIES), farM);
  }

  /** How far two bodies are apart, whether they are a pair or not. */
  double ofBodies(int one, int other, double far) {
    double x = centre[3 * one] - centre[3 * other];
    double y = centre[3 * one + 1] - centre[3 * other + 1];
    double z = centre[3 * one + 2] - centre[3 * other + 2];
    double bound = Math.sqrt(x * x + y * y + z * z) - around[one] - around[other];
    if (bound >= far) {
      return bound;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int i = start[one]; i < start[one + 1]; i++) {
      for (int j = start[other]; j < start[other + 1]; j++) {
        least =
            Math.min(
                least, SegmentDistance.apart(ends, 6 * i, ends, 6 * j) - radius[i] - radius[j]);
      }
    }
    for (int i = 0; i < solids(other); i++) {
      least = Math.min(least, toSolid(one, tool.get(i)));
    }
    return least;
  }

  private double toSolid(int one, ToolSolid solid) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = start[one]; i < start[one + 1]; i++) {
      least = Math.min(least, solid.toSegment(frames[Joints.COUNT - 1], ends, 6 * i) - radius[i]);
    }
    return least;
  }

  private double ofObstacle(int one, SolidShape obstacle, double far) {
    double bound =
        obstacle.toPoint(centre[3 * one], centre[3 * one + 1], centre[3 * one + 2]) - around[one];
    if (bound >= far) {
      return bound;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < solids(one); i++) {
      least = Math.min(least, tool.get(i).toObstacle(frames[Joints.COUNT - 1], obstacle));
    }
    for (int i = start[one]; one != LinkCapsules.TOOL && i < start[one + 1]; i++) {
      int at = 6 * i;
      least =
          Math.min(
              least,
              obstacle.toSegment(
                      ends[at],
                      ends[at + 1],
                      ends[at + 2],
                      ends[at + 3],
                      ends[at + 4],
                      ends[at + 5])
                  - radius[i]);
    }
    return least;
  }

  /** What the tool is made of besides capsules. */
  List<ToolSolid> tool() {
    return tool;
  }

  /** The flange in the base frame. */
  double[] flange12() {
    return frames[Joints.COUNT - 1];
  }

  /** Radius of a capsule, m. */
  double radiusM(int capsule) {
    return radius[capsule];
  }

  /** Ends of all capsules in the base frame, six numbers each. */
  double[] ends() {
    return ends;
  }

  /** Middles of the balls around the bodies, in the base frame. */
  double[] centres() {
    return centre;
  }

  /** Radius of the ball around a body, m. */
  double aroundM(int of) {
    return around[of];
  }

  /** The first capsule of a body; one more than the last one for the body after all. */
  int firstCapsule(int of) {
    return start[of];
  }

  /** How far a capsule of one arm is from one of another, m; with their ends in one frame. */
  static double apartM(
      ArmClearance one, double[] ends, int i, ArmClearance other, double[] otherEnds, int j) {
    return SegmentDistance.apart(ends, 6 * i, otherEnds, 6 * j) - one.radius[i] - other.radius[j];
  }
}
