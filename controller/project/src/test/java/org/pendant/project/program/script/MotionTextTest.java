package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.abc;
import static org.pendant.project.program.script.TestTrees.blended;
import static org.pendant.project.program.script.TestTrees.body;
import static org.pendant.project.program.script.TestTrees.move;
import static org.pendant.project.program.script.TestTrees.moveJ;
import static org.pendant.project.program.script.TestTrees.moveL;
import static org.pendant.project.program.script.TestTrees.position;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.suppressed;
import static org.pendant.project.program.script.TestTrees.waypoint;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** The script of moves and the places that they go to. */
final class MotionTextTest {
  private static final Pose GRIPPER = Pose.of(0, 0, 0.15, 0, 0, 0);

  private static String variable(String expression, MoveKind kind, String feature) {
    String text =
        body(
            InstallationFixture.withFeature(true),
            move(
                kind,
                new ToolChoice.Active(),
                feature,
                waypoint(new WaypointTarget.Variable(expression))));
    return text.lines().filter(line -> line.startsWith("move")).findFirst().orElse(text);
  }

  @Test
  void jointMoveSolvesThePoseNearTheTaughtJoints() {
    assertEquals(
        """
        $ 2 "MoveJ"
        $ 3 "A" "breakAfter"
        movej(get_inverse_kin(A_p, qnear=A_q), a=1.2, v=0.5)
        $ 4 "B" "breakAfter"
        movej(get_inverse_kin(B_p, qnear=B_q), a=1.2, v=0.5, r=0.02)
        """,
        body(moveJ(waypoint("A"), blended("B", 0.02))));
  }

  @Test
  void jointMoveByJointsDoesNotSolveAnything() {
    assertEquals(
        """
        $ 2 "MoveJ"
        $ 3 "A" "breakAfter"
        movej(A_q, a=1.2, v=0.5)
        """,
        body(
            node(
                new MotionStep.Move(
                    MoveKind.JOINT, 0.5, 1.2, new ToolChoice.Active(), WaypointPosition.BASE, true),
                waypoint("A"))));
  }

  @Test
  void linearAndProcessMovesGoToThePose() {
    assertEquals(
        """
        $ 2 "MoveL"
        $ 3 "A" "breakAfter"
        movel(A_p, a=1.2, v=0.5)
        $ 4 "MoveP"
        $ 5 "B" "breakAfter"
        movep(B_p, a=1.2, v=0.5, r=0.01)
        """,
        body(moveL(waypoint("A")), move(MoveKind.PROCESS, blended("B", 0.01))));
  }

  @Test
  void waypointHasItsOwnSpeedOrTime() {
    WaypointTarget target = new WaypointTarget.Fixed("A");
    assertEquals(
        """
        $ 2 "MoveL"
        $ 3 "A" "breakAfter"
        movel(A_p, a=0.3, v=0.1)
        $ 4 "A" "breakAfter"
        movel(A_p, t=2.5)
        """,
        body(
            moveL(
                waypoint(target, new Timing.Own(0.1, 0.3)),
                waypoint(target, new Timing.Duration(2.5)))));
  }

  @Test
  void aMoveOfTheFlangeLeavesTheActiveTcpAsItIs() {
    assertEquals(
        """
        $ 2 "MoveL"
        $ 3 "A" "breakAfter"
        movel(pose_trans(A_p, get_tcp_offset()), a=1.2, v=0.5)
        $ 4 "spot" "breakAfter"
        movel(pose_trans(spot, get_tcp_offset()), a=1.2, v=0.5)
        """,
        body(
            move(
                MoveKind.LINEAR,
                new ToolChoice.Flange(),
                "Base",
                waypoint("A"),
                waypoint(new WaypointTarget.Variable("spot")))));
  }

  @Test
  void relativeWaypointAddsTheDistanceOfTwoPlaces() {
    assertEquals(
        """
        $ 2 "MoveL"
        $ 3 "up" "breakAfter"
        movel(pose_add(get_target_tcp_pose(), pose_sub(B_p, A_p)), a=1.2, v=0.5)
        """,
        body(moveL(waypoint(new WaypointTarget.Relative("up", "A", "B")))));
  }

  @Test
  void variableWaypointIsAPoseInTheFeature() {
    assertEquals("movel(spot, a=1.2, v=0.5)", variable("spot", MoveKind.LINEAR, "Base"));
    assertEquals(
        "movel(pose_trans(table, spot), a=1.2, v=0.5)", variable("spot", MoveKind.LINEAR, "table"));
    assertEquals(
        "movej(pose_trans(get_target_tcp_pose(), spot), a=1.2, v=0.5)",
        variable("spot", MoveKind.JOINT, "Tool"));
  }

  @Test
  void variableWaypointOfJointsIsInNoFeature() {
    assertEquals("movej(A_q, a=1.2, v=0.5)", variable("A_q", MoveKind.JOINT, "table"));
    assertEquals(
        "movej([0, 1, 2, 3, 4, 5], a=1.2, v=0.5)",
        variable("[0, 1, 2, 3, 4, 5]", MoveKind.JOINT, "table"));
  }

  @Test
  void circleIsOneStatementForItsTwoWaypoints() {
    assertEquals(
        """
        $ 2 "MoveP"
        $ 3 "CircleMove"
        $ 4 "A" "noBreak"
        $ 5 "B" "breakAfter"
        movec(A_p, B_p, a=1.2, v=0.5, r=0.01, mode=1)
        """,
        body(
            move(
                MoveKind.PROCESS,
                node(
                    new MotionStep.CircleMove(true, OptionalDouble.of(0.01)),
                    waypoint("A"),
                    waypoint("B")))));
  }

  @Test
  void circlesAndProcessMovesSayThatTheyStop() {
    String text =
        body(
            move(
                MoveKind.PROCESS,
                waypoint("A"),
                node(
                    new MotionStep.CircleMove(false, OptionalDouble.empty()),
                    waypoint("A"),
                    waypoint("B"))));
    assertTrue(text.contains("movep(A_p, a=1.2, v=0.5, r=0.0)\n"), text);
    assertTrue(text.contains("movec(A_p, B_p, a=1.2, v=0.5, r=0.0)\n"), text);
  }

  @Test
  void homeGoesToTheJointsOfTheInstallation() {
    String joints = ScriptText.joints(Installation.NONE.homeRad());
    assertEquals(
        """
        $ 2 "Home" "breakAfter"
        movej(%s, t=3.0)
        """
            .formatted(joints),
        body(node(new MotionStep.Home(1.05, 1.4, OptionalDouble.of(3)))));
  }

  @Test
  void theToolOfAMoveIsSetBeforeEachOfItsWays() {
    Installation one = InstallationFixture.withTools("gripper", new NamedTool("gripper", GRIPPER));
    assertEquals(
        """
        $ 2 "MoveL"
        $ 3 "A" "breakAfter"
        set_tcp(%1$s)
        movel(A_p, a=1.2, v=0.5)
        $ 4 "B" "breakAfter"
        set_tcp(%1$s)
        movel(B_p, a=1.2, v=0.5)
        $ 5 "MoveL"
        $ 6 "A" "breakAfter"
        movel(A_p, a=1.2, v=0.5)
        """
            .formatted(ScriptText.pose(GRIPPER)),
        body(
            one,
            move(
                MoveKind.LINEAR,
                new ToolChoice.Named("gripper"),
                "Base",
                waypoint("A"),
                waypoint("B")),
            move(MoveKind.LINEAR, new ToolChoice.Active(), "Base", waypoint("A"))));
  }

  @Test
  void placesTaughtInAFeatureThatMovesGoWithIt() {
    ProgramTree tree =
        program(moveL(waypoint("A")))
            .withWaypoint(
                "A",
                new WaypointPosition(
                    Pose.of(0.1, 0, 0, 0, 0, 0), "table", position().jointsRad(), Pose.ZERO));
    String moving =
        ScriptGenerator.generate("x", tree, InstallationFixture.withFeature(true)).text();
    assertTrue(
        moving.contains(
            "movel(pose_trans(table, pose_trans(p[-0.4, -0.2, -0.3, 0.0, 0.0, 0.0], A_p)), a=1.2,"
                + " v=0.5)"),
        moving);
    String still =
        ScriptGenerator.generate("x", tree, InstallationFixture.withFeature(false)).text();
    assertTrue(still.contains("movel(A_p, a=1.2, v=0.5)"), still);
    assertTrue(still.contains("global A_p = p[0.5, 0.2, 0.3, 0.0, 0.0, 0.0]"), still);
  }

  @Test
  void onlyPlacesInUseAreInTheScript() {
    String text =
        ScriptGenerator.generate(
                "x",
                abc(
                    program(
                        moveL(waypoint("A"), suppressed(waypoint("B"))),
                        TestTrees.assign("here", "pose_trans(C_p, p[0, 0, 0.1, 0, 0, 0])"))),
                Installation.NONE)
            .text();
    assertTrue(text.contains("global A_p"), text);
    assertFalse(text.contains("global B_p"), text);
    assertTrue(text.contains("global C_p"), text);
  }

  @Test
  void unfinishedMovesLeaveARemark() {
    assertEquals(
        """
        $ 2 "MoveL"
        $ 3 "nowhere" "noBreak"
        # this waypoint is not complete
        $ 4 "CircleMove" "noBreak"
        # this circle needs two complete waypoints in a move
        """,
        body(
            moveL(
                waypoint("nowhere"),
                node(new MotionStep.CircleMove(true, OptionalDouble.empty()), waypoint("A")))));
    assertEquals(
        """
        $ 2 "A" "noBreak"
        # this waypoint is not complete
        """,
        body(waypoint("A")));
  }

  /** Installations for these tests. */
  static final class InstallationFixture {
    private InstallationFixture() {}

    static Installation withFeature(boolean variable) {
      Pose table = Pose.of(0.4, 0.2, 0.3, 0, 0, 0);
      return with(
          List.of(new Feature("table", FeatureKind.POINT, List.of(table), variable, false)),
          List.of(),
          "");
    }

    static Installation withTools(String active, NamedTool... tools) {
      return with(List.of(), List.of(tools), active);
    }

    private static Installation with(
        List<Feature> features, List<NamedTool> tools, String activeTool) {
      Installation none = Installation.NONE;
      return new Installation(
          none.robot(),
          none.calibration(),
          tools,
          activeTool,
          none.payloads(),
          none.activePayload(),
          none.mounting(),
          none.signals(),
          none.wiring(),
          features,
          none.homeRad(),
          none.variables(),
          none.startUp(),
          none.safety(),
          none.conveyors(),
          none.modbus(),
          none.ethernetIpLoss(),
          none.transitionHardness(),
          none.controlHost());
    }
  }
}
