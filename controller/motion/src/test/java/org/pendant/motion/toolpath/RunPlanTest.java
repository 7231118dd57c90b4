package org.pendant.motion.toolpath;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionSample;
import org.pendant.motion.PlanningException;
import org.pendant.motion.toolpath.nc.NcPath;
import org.pendant.motion.toolpath.nc.NcPoint;

class RunPlanTest {
  private static final ArmDescription ARM = ArmLibrary.load("ur5e");
  private static final ForwardKinematics FORWARD = new ForwardKinematics(ARM);
  private static final double FRAME_S = 0.002;
  private static final double A = 1.2;

  private final SplittableRandom random = new SplittableRandom(7);

  /** Where an arm stands when it is switched on. */
  private static final Joints START_RAD =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);

  private static RunPlan plan(
      ToolConfiguration toolConfiguration, boolean free, Joints from, List<QueuedMotion> orders)
      throws PlanningException {
    return RunPlan.of(
        new RunPlan.Task(ARM, toolConfiguration, free, orders, 0, from, Pose.ZERO, () -> 1));
  }

  /** Where the tool is in the work frame, frame by frame. */
  private static List<Pose> ways(ToolConfiguration toolConfiguration, Motion motion) {
    List<Pose> poses = new ArrayList<>();
    joints(motion).forEach(q -> poses.add(toolConfiguration.toolAt(FORWARD.flangePose(q))));
    return poses;
  }

  private static List<Joints> joints(Motion motion) {
    List<Joints> joints = new ArrayList<>();
    MotionSample sample = new MotionSample();
    int frames = (int) Math.ceil(motion.durationS() / FRAME_S);
    for (int i = 0; i <= frames; i++) {
      double timeS = Math.min(motion.durationS(), i * FRAME_S);
      assertTrue(motion.sample(timeS, sample).isEmpty());
      joints.add(sample.positionRad());
    }
    return joints;
  }

  private double some(double around) {
    return random.nextDouble(-around, around);
  }

  private Pose somePose(double place, double turn) {
    return new Pose(some(place), some(place), some(place), some(turn), some(turn), some(turn));
  }

  private static Leg.Limits pace(double speed, double radius) {
    return new Leg.Limits(A, speed, radius, false);
  }

  private static QueuedMotion.Path path(List<Pose> points, double speed, double radius) {
    List<NcPoint> listed = new ArrayList<>();
    for (Pose point : points) {
      listed.add(new NcPoint(point, speed, listed.size() + 1));
    }
    return new QueuedMotion.Path(
        new NcPath("test.nc", listed, List.of()),
        Pose.ZERO,
        true,
        new Leg.Limits(A, 0, radius, true));
  }

  private static double distance(Pose p, Pose a, Pose b) {
    double x = b.x() - a.x();
    double y = b.y() - a.y();
    double z = b.z() - a.z();
    double square = x * x + y * y + z * z;
    double along =
        square == 0
            ? 0
            : ((p.x() - a.x()) * x + (p.y() - a.y()) * y + (p.z() - a.z()) * z) / square;
    double f = Math.max(0, Math.min(1, along));
    return Math.sqrt(
        Math.pow(p.x() - a.x() - f * x, 2)
            + Math.pow(p.y() - a.y() - f * y, 2)
            + Math.pow(p.z() - a.z() - f * z, 2));
  }

  private static double distance(Pose p, List<Pose> line) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i + 1 < line.size(); i++) {
      least = Math.min(least, distance(p, line.get(i), line.get(i + 1)));
    }
    return least;
  }

  @Test
  void thePartMeetsTheToolThatStandsStillAtEveryFrame() throws PlanningException {
    for (int run = 0; run < 40; run++) {
      Pose flange = FORWARD.flangePose(START_RAD);
      Pose tool =
          Poses.trans(flange, Poses.trans(new Pose(0, 0, 0.15, 0, 0, 0), somePose(0.05, 1)));
      ToolConfiguration toolConfiguration = new ToolConfiguration(true, tool);
      Pose pcs = somePose(0.2, 2);
      List<Pose> points = new ArrayList<>(List.of(toolConfiguration.toolAt(flange)));
      List<QueuedMotion> orders = new ArrayList<>();
      for (int i = 0; i < 4; i++) {
        Pose inPart =
            Poses.trans(Poses.inverse(pcs), Poses.trans(points.getFirst(), somePose(0.05, 0.15)));
        points.add(Poses.trans(pcs, inPart));
        orders.add(new QueuedMotion.Line(points.getLast(), pace(0.1, 0)));
      }
      RunPlan plan = plan(toolConfiguration, run % 2 == 0, START_RAD, orders);
      for (Pose place : ways(toolConfiguration, plan.motion().orElseThrow())) {
        double aside = distance(place, points);
        assertTrue(aside < 1e-6, "run " + run + ": " + aside + " m aside");
      }
      assertTrue(Poses.pointDistance(points.getLast(), plan.endInWork()) < 1e-8);
    }
  }

  @Test
  void aLongSmoothPathTakesItsLengthByItsFeedRate() throws PlanningException {
    ToolConfiguration toolConfiguration = new ToolConfiguration(false, Pose.ZERO);
    Pose start = FORWARD.flangePose(START_RAD);
    for (double radius : new double[] {0, 0.001}) {
      List<Pose> points = new ArrayList<>();
      double length = 0;
      for (int i = 0; i <= 900; i++) {
        double angle = 2 * Math.PI * i / 300;
        points.add(
            start
                .with(0, start.x() - 0.08 * (1 - Math.cos(angle)))
                .with(1, start.y() + 0.08 * Math.sin(angle)));
        length += i == 0 ? 0 : Poses.pointDistance(points.get(i - 1), points.get(i));
      }
      RunPlan plan =
          plan(toolConfiguration, false, START_RAD, List.of(path(points, 0.025, radius)));
      double lastsS = plan.motion().orElseThrow().durationS();
      assertEquals(length / 0.025, lastsS, 0.02 * length / 0.025);
    }
  }

  @Test
  void cornersStayWithinTheToleranceAndTheAcceleration() throws PlanningException {
    ToolConfiguration toolConfiguration = new ToolConfiguration(false, Pose.ZERO);
    Pose start = FORWARD.flangePose(START_RAD);
    for (int run = 0; run < 30; run++) {
      double radius = run % 3 == 0 ? 0 : random.nextDouble(0.0005, 0.02);
      List<Pose> points = new ArrayList<>(List.of(start));
      for (int i = 0; i < 30; i++) {
        Pose last = points.getLast();
        points.add(
            last.with(0, last.x() + some(0.01))
                .with(1, last.y() + some(0.01))
                .with(2, last.z() + some(0.005)));
      }
      RunPlan plan = plan(toolConfiguration, false, START_RAD, List.of(path(points, 0.2, radius)));
      List<Pose> ways = ways(toolConfiguration, plan.motion().orElseThrow());
      double allowed = Math.max(radius, Chaining.TOLERANCE_M) + 1e-9;
      for (int i = 0; i < ways.size(); i++) {
        assertTrue(distance(ways.get(i), points) <= allowed, "aside in run " + run);
        if (i > 1 && i + 1 < ways.size()) {
          double bend = bend(ways.get(i - 2), ways.get(i - 1), ways.get(i)) / (FRAME_S * FRAME_S);
          assertTrue(bend <= A * 1.001, "run " + run + ", frame " + i + ": " + bend + " m/s²");
        }
      }
      for (Pose point : points) {
        double nearest =
            ways.stream().mapToDouble(way -> Poses.pointDistance(way, point)).min().orElseThrow();
        // half of a frame's travel besides
        assertTrue(nearest <= allowed + 0.2 * FRAME_S, nearest + " m from a point");
      }
    }
  }

  private static double bend(Pose a, Pose b, Pose c) {
    return Math.sqrt(
        Math.pow(a.x() - 2 * b.x() + c.x(), 2)
            + Math.pow(a.y() - 2 * b.y() + c.y(), 2)
            + Math.pow(a.z() - 2 * b.z() + c.z(), 2));
  }

  @Test
  void anArcBlendsWithALineWithoutStopping() throws PlanningException {
    ToolConfiguration toolConfiguration = new ToolConfiguration(false, Pose.ZERO);
    Pose start = FORWARD.flangePose(START_RAD);
    Pose first = start.with(1, start.y() + 0.05);
    Pose via = first.with(0, first.x() - 0.03).with(1, first.y() + 0.03);
    Pose to = first.with(1, first.y() + 0.06);
    List<QueuedMotion> orders =
        List.of(
            new QueuedMotion.Line(first, pace(0.1, 0.01)),
            new QueuedMotion.Arc(via, to, true, pace(0.1, 0)));
    RunPlan plan = plan(toolConfiguration, false, START_RAD, orders);
    List<Pose> ways = ways(toolConfiguration, plan.motion().orElseThrow());
    double slowest = 1;
    for (int i = 0; i + 1 < ways.size(); i++) {
      if (Poses.pointDistance(ways.get(i), first) < 0.015) {
        slowest = Math.min(slowest, Poses.pointDistance(ways.get(i), ways.get(i + 1)) / FRAME_S);
      }
    }
    assertTrue(slowest > 0.03, "slowest " + slowest);
    assertTrue(Poses.pointDistance(to, ways.getLast()) < 1e-9);
    // half a circle with the tangent turns the tool by half a turn
    assertEquals(Math.PI, Poses.rotationAngle(start, ways.getLast()), 1e-6);
  }

  @Test
  void aToolThatMayTurnFreelyKeepsItsAxisAndSparesItsWrist() throws PlanningException {
    ToolConfiguration toolConfiguration =
        new ToolConfiguration(false, new Pose(0, 0, 0.1, Math.PI, 0, 0));
    Pose start = toolConfiguration.toolAt(FORWARD.flangePose(START_RAD));
    List<Pose> points = new ArrayList<>();
    for (int i = 0; i <= 400; i++) {
      Pose turned = Poses.trans(start, new Pose(0, 0, 0, 0, 0, 1.5 * Math.PI * i / 400));
      points.add(turned.with(1, start.y() + 0.0005 * i));
    }
    List<QueuedMotion> orders = List.of(path(points, 0.05, 0.001));
    List<Joints> bound =
        joints(plan(toolConfiguration, false, START_RAD, orders).motion().orElseThrow());
    List<Joints> free =
        joints(plan(toolConfiguration, true, START_RAD, orders).motion().orElseThrow());
    assertEquals(1.5 * Math.PI, travelled(bound), 0.5);
    assertTrue(travelled(free) < 1, travelled(free) + " rad of wrist 3");
    for (Joints q : free) {
      Pose tool = toolConfiguration.toolAt(FORWARD.flangePose(q));
      assertTrue(distance(tool, points.getFirst(), points.getLast()) < 1e-8);
      assertEquals(1, cosineOfAxes(tool, start), 1e-9);
    }
    for (int i = 2; i < free.size(); i++) {
      for (int k = 0; k < 6; k++) {
        double bend = free.get(i).get(k) - 2 * free.get(i - 1).get(k) + free.get(i - 2).get(k);
        assertTrue(Math.abs(bend) < 20 * FRAME_S * FRAME_S, "joint " + k + " in frame " + i);
      }
    }
  }

  private static double travelled(List<Joints> joints) {
    return Math.abs(joints.getLast().get(5) - joints.getFirst().get(5));
  }

  private static double cosineOfAxes(Pose a, Pose b) {
    Pose up = new Pose(0, 0, 1, 0, 0, 0);
    Pose ofA = Poses.trans(a.with(0, 0).with(1, 0).with(2, 0), up);
    Pose ofB = Poses.trans(b.with(0, 0).with(1, 0).with(2, 0), up);
    return ofA.x() * ofB.x() + ofA.y() * ofB.y() + ofA.z() * ofB.z();
  }

  @Test
  void aFreeTurnLeadsAwayFromAJointLimit() throws PlanningException {
    ToolConfiguration toolConfiguration =
        new ToolConfiguration(false, new Pose(0, 0, 0.1, Math.PI, 0, 0));
    Joints wound = START_RAD.with(5, 2 * Math.PI - 0.05);
    Pose start = toolConfiguration.toolAt(FORWARD.flangePose(wound));
    List<Pose> points = List.of(start.with(1, start.y() + 0.2));
    List<Joints> free =
        joints(
            plan(toolConfiguration, true, wound, List.of(path(points, 0.05, 0)))
                .motion()
                .orElseThrow());
    assertTrue(free.getLast().get(5) < 2 * Math.PI - 0.3, "wrist 3 at " + free.getLast().get(5));
  }

  @Test
  void whatCannotBeReachedIsRefusedWithMotionFileAndLine() {
    ToolConfiguration toolConfiguration = new ToolConfiguration(false, Pose.ZERO);
    Pose start = FORWARD.flangePose(START_RAD);
    List<Pose> points = List.of(start, start.with(0, start.x() + 3));
    PlanningException error =
        assertThrows(
            PlanningException.class,
            () -> plan(toolConfiguration, false, START_RAD, List.of(path(points, 0.1, 0))));
    assertTrue(
        error.getMessage().startsWith("motion 0 (test.nc:2): no joint positions reach"),
        error.getMessage());
  }

  @Test
  void aWristThatWouldTurnBeyondItsRangeIsRefused() {
    ToolConfiguration toolConfiguration = new ToolConfiguration(false, Pose.ZERO);
    Pose start = FORWARD.flangePose(START_RAD);
    List<Pose> points = new ArrayList<>();
    for (int i = 0; i <= 100; i++) {
      Pose turned = Poses.trans(start, new Pose(0, 0, 0, 0, 0, 5 * Math.PI * i / 100));
      points.add(turned.with(1, start.y() + 0.001 * i));
    }
    PlanningException error =
        assertThrows(
            PlanningException.class,
            () -> plan(toolConfiguration, false, START_RAD, List.of(path(points, 0.1, 0.001))));
    assertTrue(
        error.getMessage().contains("joint 5 is at the end of its range"), error.getMessage());
  }

  @Test
  void anArcWithoutAPlaneIsALineOrRefused() throws PlanningException {
    ToolConfiguration toolConfiguration = new ToolConfiguration(false, Pose.ZERO);
    Pose start = FORWARD.flangePose(START_RAD);
    Pose near = start.with(1, start.y() + 0.02);
    Pose far = start.with(1, start.y() + 0.05);
    RunPlan line =
        plan(
            toolConfiguration,
            false,
            START_RAD,
            List.of(new QueuedMotion.Arc(near, far, false, pace(0.1, 0))));
    assertTrue(Poses.pointDistance(far, line.endInWork()) < 1e-9);
    for (List<Pose> wrong :
        List.of(List.of(far, near), List.of(near, start), List.of(start, start))) {
      PlanningException error =
          assertThrows(
              PlanningException.class,
              () ->
                  plan(
                      toolConfiguration,
                      false,
                      START_RAD,
                      List.of(
                          new QueuedMotion.Arc(
                              wrong.getFirst(), wrong.getLast(), false, pace(0.1, 0)))));
      assertTrue(error.getMessage().startsWith("motion 0: there is no arc"), error.getMessage());
    }
  }

  @Test
  void aRunToWhereTheToolIsMovesNothing() throws PlanningException {
    ToolConfiguration toolConfiguration = new ToolConfiguration(false, Pose.ZERO);
    Pose start = FORWARD.flangePose(START_RAD);
    RunPlan plan =
        plan(
            toolConfiguration,
            false,
            START_RAD,
            List.of(new QueuedMotion.Line(start, pace(0.1, 0))));
    assertTrue(plan.motion().isEmpty());
  }
}
