package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.abc;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.blended;
import static org.pendant.project.program.script.TestTrees.move;
import static org.pendant.project.program.script.TestTrees.moveJ;
import static org.pendant.project.program.script.TestTrees.moveL;
import static org.pendant.project.program.script.TestTrees.position;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.waypoint;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;
import org.pendant.project.program.script.MotionTextTest.InstallationFixture;

/** Where moves bring the arm of a controller. */
final class MotionRunTest {
  private static final Pose GRIPPER = Pose.of(0, 0, 0.15, 0, 0, 0);
  private static final Joints A = position(0.2).jointsRad();
  private static final Joints B = position(0.2, 0.2).jointsRad();
  private static final Joints C = position(-0.2, 0.1, 0.1).jointsRad();

  private static Joints joints(TreeRun run) {
    return run.state().arm().targetPositionRad();
  }

  private static Pose pose(TreeRun run) {
    return run.state().arm().targetTcpInBase();
  }

  private static void assertAt(Joints wanted, TreeRun run) {
    assertTrue(
        joints(run).maxAbsDifference(wanted) < 1e-6, () -> wanted + " is not " + joints(run));
  }

  private static void assertAt(Pose wanted, TreeRun run) {
    assertTrue(Poses.distance(wanted, pose(run)) < 1e-6, () -> wanted + " is not " + pose(run));
  }

  private static ProgramNode jointsOnly(ProgramNode... children) {
    return node(
        new MotionStep.Move(
            MoveKind.JOINT, 1, 1, new ToolChoice.Active(), WaypointPosition.BASE, true),
        children);
  }

  @Test
  void everyKindOfMoveReachesItsWaypoints() {
    assertAt(B, TreeRun.of(abc(program(moveJ(waypoint("A"), waypoint("B"))))));
    assertAt(B, TreeRun.of(abc(program(moveL(waypoint("A"), waypoint("B"))))));
    assertAt(B, TreeRun.of(abc(program(move(MoveKind.PROCESS, waypoint("A"), waypoint("B"))))));
    assertAt(C, TreeRun.of(abc(program(jointsOnly(waypoint("A"), waypoint("C"))))));
  }

  @Test
  void waypointsOfOneNameShareOnePlace() {
    TreeRun run =
        new TreeRun(
                abc(
                    program(
                        moveL(waypoint("A")),
                        say("A"),
                        sleep(0.1),
                        moveJ(waypoint("B"), waypoint("A")))))
            .until("A");
    assertAt(A, run);
    assertAt(A, run.finish());
  }

  @Test
  void waypointsTakeTheTimeThatTheyAreGiven() {
    TreeRun run =
        TreeRun.of(
            abc(program(moveL(waypoint(new WaypointTarget.Fixed("A"), new Timing.Duration(2.5))))));
    assertEquals(2.5, run.timeS(), 0.02);
    assertAt(A, run);
  }

  @Test
  void waypointsGoAtTheirOwnSpeed() {
    double wayRad = 0.2;
    double speedRadPerS = 0.05;
    TreeRun run =
        TreeRun.of(
            abc(
                program(
                    moveJ(
                        waypoint(
                            new WaypointTarget.Fixed("A"), new Timing.Own(speedRadPerS, 10))))));
    assertEquals(wayRad / speedRadPerS, run.timeS(), 0.1);
  }

  @Test
  void blendedWaypointsArePassedWithoutAStop() {
    assertTrue(slowestRadPerS(blended("A", 0.03)) > 0.05);
    assertTrue(slowestRadPerS(waypoint("A")) < 0.001);
  }

  /** How fast the base turns at least between the middles of the ways to A and on to C. */
  private static double slowestRadPerS(ProgramNode first) {
    ProgramTree tree = TestTrees.taught(abc(program(moveJ(first, waypoint("D")))), "D", 0.6, 0.2);
    TreeRun run = new TreeRun(tree);
    double slowest = Double.MAX_VALUE;
    while (run.running()) {
      run.advance(1);
      double at = joints(run).q0();
      if (at > 0.1 && at < 0.4) {
        slowest = Math.min(slowest, Math.abs(run.state().arm().targetSpeedRadPerS().q0()));
      }
    }
    return slowest;
  }

  @Test
  void relativeWaypointsGoAsFarAsTheirPlacesAreApart() {
    Pose a = position(0.2).tcp();
    Pose b = position(0.2, 0.2).tcp();
    Pose c = position(-0.2, 0.1, 0.1).tcp();
    ProgramNode way = waypoint(new WaypointTarget.Relative("way", "A", "B"));
    assertAt(
        Poses.add(c, Poses.sub(b, a)), TreeRun.of(abc(program(moveJ(waypoint("C")), moveL(way)))));
    assertAt(
        Joints.of(-0.2, -1.2, -1.5, -1.6, 1.5, 0),
        TreeRun.of(abc(program(jointsOnly(waypoint("C"), way)))));
  }

  @Test
  void variableWaypointsGoWhereTheirVariableSays() {
    TreeRun run =
        TreeRun.of(
            abc(
                program(
                    assign("spot", "pose_trans(A_p, p[0, 0, 0.05, 0, 0, 0])"),
                    moveL(waypoint(new WaypointTarget.Variable("spot"))))));
    assertAt(Poses.trans(position(0.2).tcp(), Pose.of(0, 0, 0.05, 0, 0, 0)), run);
    assertAt(
        B,
        TreeRun.of(
            abc(
                program(
                    assign("there", "B_q"),
                    moveJ(waypoint(new WaypointTarget.Variable("there")))))));
  }

  @Test
  void variableWaypointsAreSeenFromTheFeature() {
    Pose spot = Poses.trans(Poses.inverse(Pose.of(0.4, 0.2, 0.3, 0, 0, 0)), position(0.1).tcp());
    ProgramTree tree =
        program(
            assign("spot", ScriptText.pose(spot)),
            move(
                MoveKind.LINEAR,
                new ToolChoice.Active(),
                "table",
                waypoint(new WaypointTarget.Variable("spot"))));
    assertAt(position(0.1).tcp(), TreeRun.of(tree, InstallationFixture.withFeature(false)));
  }

  @Test
  void placesGoAlongWithAFeatureThatIsMoved() {
    Pose table = Pose.of(0.4, 0.2, 0.3, 0, 0, 0);
    Pose tcp = Poses.trans(Poses.inverse(table), position(0.1).tcp());
    ProgramTree tree =
        program(assign("table", "pose_trans(p[0, 0, 0.05, 0, 0, 0], table)"), moveL(waypoint("A")))
            .withWaypoint(
                "A", new WaypointPosition(tcp, "table", position(0.1).jointsRad(), Pose.ZERO));
    assertAt(
        Poses.trans(Pose.of(0, 0, 0.05, 0, 0, 0), position(0.1).tcp()),
        TreeRun.of(tree, InstallationFixture.withFeature(true)));
  }

  @Test
  void circlesPassTheirFirstWaypointAndEndAtTheSecond() {
    Pose start = position(0.1).tcp();
    Pose via = Poses.trans(start, Pose.of(0.05, 0.05, 0, 0, 0, 0));
    Pose end = Poses.trans(start, Pose.of(0, 0.1, 0, 0, 0, 0));
    Joints near = position(0.1).jointsRad();
    ProgramTree tree =
        program(
                move(
                    MoveKind.PROCESS,
                    waypoint("start"),
                    node(
                        new MotionStep.CircleMove(false, OptionalDouble.empty()),
                        waypoint("via"),
                        waypoint("end"))))
            .withWaypoint("start", new WaypointPosition(start, "Base", near, Pose.ZERO))
            .withWaypoint("via", new WaypointPosition(via, "Base", near, Pose.ZERO))
            .withWaypoint("end", new WaypointPosition(end, "Base", near, Pose.ZERO));
    TreeRun run = new TreeRun(tree);
    double nearest = Double.MAX_VALUE;
    while (run.running()) {
      run.advance(1);
      nearest = Math.min(nearest, Poses.pointDistance(via, pose(run)));
    }
    assertTrue(nearest < 0.002, "missed by " + nearest);
    assertAt(end, run);
  }

  @Test
  void homeIsReachedInItsTime() {
    ProgramNode home = node(new MotionStep.Home(1, 1, OptionalDouble.of(1.5)));
    TreeRun run = TreeRun.of(program(home));
    assertAt(Installation.NONE.homeRad(), run);
    assertEquals(1.5, run.timeS(), 0.02);
    assertAt(
        Installation.NONE.homeRad(),
        TreeRun.of(program(node(new MotionStep.Home(1, 1, OptionalDouble.empty())))));
  }

  @Test
  void theChosenToolGoesToThePlace() {
    Installation two = InstallationFixture.withTools("", new NamedTool("gripper", GRIPPER));
    TreeRun run =
        TreeRun.of(
            abc(
                program(
                    move(MoveKind.LINEAR, new ToolChoice.Named("gripper"), "Base", waypoint("A")))),
            two);
    assertEquals(GRIPPER, run.state().arm().tool().inFlange());
    assertAt(position(0.2).tcp(), run);
  }

  @Test
  void theFlangeGoesWhereItStoodWithAToolOnIt() {
    WaypointPosition flange = position(0.2);
    ProgramTree tree =
        program(move(MoveKind.LINEAR, new ToolChoice.Flange(), "Base", waypoint("A")))
            .withWaypoint(
                "A",
                new WaypointPosition(
                    Poses.trans(flange.tcp(), GRIPPER), "Base", flange.jointsRad(), GRIPPER));
    TreeRun run =
        TreeRun.of(
            tree, InstallationFixture.withTools("gripper", new NamedTool("gripper", GRIPPER)));
    assertEquals(GRIPPER, run.state().arm().tool().inFlange(), "the TCP stays active");
    assertAt(A, run);
  }
}
