package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.collision.Capsule;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Arm bodies: what one arm has among the objects of a scene that have a mass. Its tool points are
 * balls that push them, and feel them; its links and grippers do so as well.
 */
final class ArmBodies {
  /** A tool point without a radius is a ball of this one to them, m. */
  private static final double MIN_POINT_M = 0.002;

  /**
   * What an arm is among them.
   *
   * @param tool no points for the tool centre point alone
   * @param capsules of the links that push them; empty where links pass through them
   * @param baseInCell where it stands in the frame that the objects are given in
   */
  record Setup(SceneTool tool, List<Capsule> capsules, Pose baseInCell) {}

  private final Setup setup;
  private final List<ToolPoint> points;
  private final ArmPlace place;
  private final LinkBodies links;
  private final ToolBodies toolBodies;
  private final List<Gripper> grippers = new ArrayList<>();

  /** Numbers of the bodies of the tool: its points, and the fingers of grippers. */
  private final List<Integer> tools = new ArrayList<>();

  private RigidBodyWorld bodies;
  private int firstPoint;
  private int firstToolBody;
  private int firstLink;

  /** Force and torque on the flange's origin, along the base's axes, in the latest step. */
  private final double[] felt6 = new double[6];

  private final double[] ball12 = new double[Transforms.SIZE];
  private final double[] ballTwist6 = new double[6];
  private final double[] ballWrench6 = new double[6];

  /** Where the flange was placed last, in the cell's frame. */
  private final double[] flange12 = new double[Transforms.SIZE];

  private final double[] tcpInFlange3 = new double[3];
  private boolean onlyTcp;

  ArmBodies(Setup setup) {
    this.setup = setup;
    place = new ArmPlace(setup.baseInCell());
    links = new LinkBodies(setup.capsules(), place);
    toolBodies = new ToolBodies(setup.tool().bodies());
    points =
        setup.tool().points().isEmpty()
            ? List.of(new ToolPoint(new Vector3(0, 0, 0), 0))
            : setup.tool().points();
  }

  /** Whether it is the tool centre point that touches, as the scene names no tool points. */
  boolean onlyTcp() {
    return setup.tool().points().isEmpty();
  }

  /** Bodies of its tool points, and of the solids of its tool after them. */
  List<BodyDescription> toolDescriptions(int arm) {
    List<BodyDescription> all = new ArrayList<>();
    for (int i = 0; i < points.size(); i++) {
      double radiusM = Math.max(MIN_POINT_M, points.get(i).radiusM());
      // a line break is in no object's name
      all.add(
          BodyDescription.kinematic(
              (arm == 0 ? "tool\n" : "tool\n" + arm + "\n") + i,
              new BodyShape.Sphere(radiusM),
              Pose.ZERO,
              new BodySurface(Material.DEFAULT.friction(), 0, Material.STIFFNESS.most())));
    }
    all.addAll(toolBodies.descriptions(arm == 0 ? "solid\n" : "solid\n" + arm + "\n"));
    return all;
  }

  /** Bodies of its links. */
  List<BodyDescription> linkDescriptions(int arm) {
    return links.descriptions(arm == 0 ? "link\n" : "link\n" + arm + "\n");
  }

  /**
   * Its bodies are there now: those of the points from one number on, of the links from another.
   */
  void added(RigidBodyWorld bodies, int firstPoint, int firstLink) {
    this.bodies = bodies;
    this.firstPoint = firstPoint;
    this.firstLink = firstLink;
    firstToolBody = firstPoint + points.size();
    for (int i = 0; i < points.size() + toolBodies.count(); i++) {
      tools.add(firstPoint + i);
    }
  }

  /**
   * Says where the links are, and how they move.
   *
   * @param linkFrames Denavit-Hartenberg frames 1 to 6 in the base frame
   * @param qd joint speeds, rad/s
   */
  void moveLinks(double[][] linkFrames, double[] qd) {
    links.move(place.inCell(linkFrames), qd, bodies, firstLink);
  }

  /** Adds the torques that joints feel of what links push, Nm. */
  void addTorques(double[] torqueNm) {
    links.addTorques(torqueNm, bodies, firstLink);
  }

  /**
   * Says where the tool is, and how it moves.
   *
   * @param flangeInBase12 the flange in the base frame
   * @param tcpInFlange3 the tool centre point in the flange's frame, m
   * @param tcpInFlange the same with its orientation
   * @param onlyTcp whether the tool centre point is what touches
   * @param twistInBase6 velocity of the flange's origin and angular velocity, along the base's axes
   */
  void move(
      double[] flangeInBase12,
      double[] tcpInFlange3,
      Pose tcpInFlange,
      boolean onlyTcp,
      double[] twistInBase6) {
    System.arraycopy(place.inCell(flangeInBase12), 0, flange12, 0, Transforms.SIZE);
    double[] twist6 = place.twistInCell(twistInBase6);
    System.arraycopy(tcpInFlange3, 0, this.tcpInFlange3, 0, 3);
    this.onlyTcp = onlyTcp;
    for (Gripper gripper : grippers) {
      gripper.place(flange12, tcpInFlange, twist6);
    }
    toolBodies.move(flange12, twist6, bodies, firstToolBody);
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
      bodies.moveKinematic(firstPoint + i, ball12, ballTwist6);
    }
  }

  /** The bodies have moved: takes what the tool felt of them. */
  void feel() {
    Arrays.fill(felt6, 0);
    for (int i = 0; i < points.size(); i++) {
      bodies.wrench(firstPoint + i, ballWrench6);
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
    toolBodies.addWrench(flange12, bodies, firstToolBody, felt6);
    for (int i = 0; i < grippers.size(); i++) {
      grippers.get(i).addWrench(flange12, felt6);
    }
    place.turnToBase(felt6);
  }

  /** Adds what the tool feels of the bodies, along the axes of the base. */
  void addWrench(double[] wrench6) {
    for (int k = 0; k < 6; k++) {
      wrench6[k] += felt6[k];
    }
  }

  /**
   * Takes a gripper. The tool centre point, which lies between its fingers, touches none of these
   * bodies any more where the scene names no tool points.
   */
  <H extends Gripper> H take(H gripper) {
    grippers.add(gripper);
    if (gripper instanceof ParallelGripper && onlyTcp()) {
      bodies.setPresent(firstPoint, false);
    }
    return gripper;
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

  /** Whether a gripper holds something. */
  boolean holds() {
    for (int i = 0; i < grippers.size(); i++) {
      if (grippers.get(i).holds()) {
        return true;
      }
    }
    return false;
  }

  /** Whether a gripper has to be reckoned with even where nothing else moves. */
  boolean busy() {
    for (int i = 0; i < grippers.size(); i++) {
      if (grippers.get(i).busy()) {
        return true;
      }
    }
    return false;
  }
}
