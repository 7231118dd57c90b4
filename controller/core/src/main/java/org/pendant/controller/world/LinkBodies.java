package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.arm.Joints;
import org.pendant.models.collision.Capsule;
import org.pendant.models.collision.LinkCapsules;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Link bodies: the links of the arm among the objects that have a mass: they push them, and feel
 * them as torques of the joints. Wrist 3 is not among them: tool points stand for what is there.
 */
final class LinkBodies {
  /** Capsules shorter than this are balls, m. */
  private static final double MIN_LENGTH_M = 0.001;

  private final List<Capsule> capsules;
  private final ArmPlace place;

  /** Pose of each capsule in the frame of its link, as {@link Transforms} has it. */
  private final double[][] inLink;

  /** Where the axes of the joints are and how they point, in the cell, three numbers each. */
  private final double[] axis = new double[3 * Joints.COUNT];

  private final double[] origin = new double[3 * Joints.COUNT];
  private final double[] pose12 = new double[Transforms.SIZE];
  private final double[] twist6 = new double[6];
  private final double[] wrench6 = new double[6];

  /** How each link moves: m/s of a point of it at the cell's origin, and rad/s. */
  private final double[] motion = new double[6 * Joints.COUNT];

  /**
   * Links that push.
   *
   * @param links what they are made of; empty for an arm that passes through everything
   * @param place of the arm; all frames here are in its cell
   */
  LinkBodies(List<Capsule> links, ArmPlace place) {
    capsules = links.stream().filter(each -> each.body() < LinkCapsules.WRIST_3).toList();
    inLink = new double[capsules.size()][Transforms.SIZE];
    for (int i = 0; i < inLink.length; i++) {
      stand(capsules.get(i), inLink[i]);
    }
    double[] base12 = place.baseInCell12();
    for (int row = 0; row < 3; row++) {
      axis[row] = base12[3 * row + 2];
      origin[row] = base12[9 + row];
    }
    this.place = place;
  }

  /**
   * Bodies of these links, to be added to a world after its others.
   *
   * @param prefix that their names begin with
   */
  List<BodyDescription> descriptions(String prefix) {
    List<BodyDescription> all = new ArrayList<>();
    for (int i = 0; i < inLink.length; i++) {
      Capsule capsule = capsules.get(i);
      double lengthM = length(capsule);
      BodyShape shape =
          lengthM < MIN_LENGTH_M
              ? new BodyShape.Sphere(capsule.radiusM())
              : new BodyShape.Capsule(capsule.radiusM(), lengthM);
      all.add(
          BodyDescription.kinematic(
              prefix + i,
              shape,
              capsule.body() == LinkCapsules.BASE
                  ? place.inCell(Transforms.toPose(inLink[i]))
                  : Pose.ZERO,
              new BodySurface(Material.DEFAULT.friction(), 0, Material.STIFFNESS.most())));
    }
    return all;
  }

  /**
   * Moves the bodies.
   *
   * @param linkFrames Denavit-Hartenberg frames 1 to 6 in the cell
   * @param qd joint speeds, rad/s
   * @param first the number of the first of the bodies
   */
  void move(double[][] linkFrames, double[] qd, RigidBodyWorld bodies, int first) {
    for (int joint = 1; joint < Joints.COUNT; joint++) {
      double[] before = linkFrames[joint - 1];
      for (int row = 0; row < 3; row++) {
        axis[3 * joint + row] = before[3 * row + 2];
        origin[3 * joint + row] = before[9 + row];
      }
    }
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      addMotion(joint, qd[joint]);
    }
    for (int i = 0; i < inLink.length; i++) {
      int link = capsules.get(i).body() - 1;
      if (link < 0) {
        continue;
      }
      Transforms.multiply(linkFrames[link], inLink[i], pose12);
      double x = pose12[9];
      double y = pose12[10];
      double z = pose12[11];
      int at = 6 * link;
      double wx = motion[at + 3];
      double wy = motion[at + 4];
      double wz = motion[at + 5];
      twist6[0] = motion[at] + wy * z - wz * y;
      twist6[1] = motion[at + 1] + wz * x - wx * z;
      twist6[2] = motion[at + 2] + wx * y - wy * x;
      twist6[3] = wx;
      twist6[4] = wy;
      twist6[5] = wz;
      bodies.moveKinematic(first + i, pose12, twist6);
    }
  }

  /** A joint moves a point p by z x (p - o): by o x z at the cell's origin, and z x p more. */
  private void addMotion(int joint, double speed) {
    int at = 6 * joint;
    int of = 3 * joint;
    for (int k = 0; k < 3; k++) {
      int one = of + (k + 1) % 3;
      int two = of + (k + 2) % 3;
      double before = joint == 0 ? 0 : motion[at - 6 + k];
      double turnBefore = joint == 0 ? 0 : motion[at - 3 + k];
      motion[at + k] = before + speed * (origin[one] * axis[two] - origin[two] * axis[one]);
      motion[at + 3 + k] = turnBefore + speed * axis[of + k];
    }
  }

  /** Adds the torques that the joints feel of what touched in the latest step, Nm. */
  void addTorques(double[] torqueNm, RigidBodyWorld bodies, int first) {
    for (int i = 0; i < inLink.length; i++) {
      bodies.wrench(first + i, wrench6);
      if (wrench6[0] == 0 && wrench6[1] == 0 && wrench6[2] == 0) {
        continue;
      }
      bodies.pose(first + i, pose12);
      for (int joint = 0; joint < capsules.get(i).body(); joint++) {
        torqueNm[joint] += torqueNm(3 * joint);
      }
    }
  }

  private double torqueNm(int of) {
    double x = pose12[9] - origin[of];
    double y = pose12[10] - origin[of + 1];
    double z = pose12[11] - origin[of + 2];
    return axis[of] * (wrench6[3] + y * wrench6[2] - z * wrench6[1])
        + axis[of + 1] * (wrench6[4] + z * wrench6[0] - x * wrench6[2])
        + axis[of + 2] * (wrench6[5] + x * wrench6[1] - y * wrench6[0]);
  }

  private static double length(Capsule c) {
    return new Vector3(c.bx() - c.ax(), c.by() - c.ay(), c.bz() - c.az()).length();
  }

  /** The pose in the middle of a capsule whose z is its axis. */
  private static void stand(Capsule c, double[] transform) {
    double length = length(c);
    Vector3 along =
        length < MIN_LENGTH_M
            ? new Vector3(0, 0, 1)
            : new Vector3(
                (c.bx() - c.ax()) / length, (c.by() - c.ay()) / length, (c.bz() - c.az()) / length);
    double across = Math.hypot(along.x(), along.y());
    double angle = Math.atan2(across, along.z());
    double rx = across > 0 ? -along.y() / across * angle : angle;
    double ry = across > 0 ? along.x() / across * angle : 0;
    Pose middle =
        new Pose((c.ax() + c.bx()) / 2, (c.ay() + c.by()) / 2, (c.az() + c.bz()) / 2, rx, ry, 0);
    Transforms.of(middle, transform);
  }
}
