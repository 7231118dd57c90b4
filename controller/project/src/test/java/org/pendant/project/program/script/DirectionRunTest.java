package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.moveJ;
import static org.pendant.project.program.script.TestTrees.moveL;
import static org.pendant.project.program.script.TestTrees.output;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.suppressed;
import static org.pendant.project.program.script.TestTrees.tree;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.IoCommand;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.MotionStep.Direction;
import org.pendant.project.program.MotionStep.Until;
import org.pendant.project.program.MotionStep.Waypoint;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Timing;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** Directions, and waypoints on the way to which something else ends the move. */
final class DirectionRunTest {
  private static ProgramNode direction(
      String feature, double x, double y, double z, double speed, ProgramNode... untils) {
    return node(
        new Direction(feature, x, y, z, OptionalDouble.of(speed), OptionalDouble.of(1)), untils);
  }

  private static ProgramNode down(double speed, ProgramNode... untils) {
    return direction(WaypointPosition.BASE, 0, 0, -1, speed, untils);
  }

  private static ProgramNode until(UntilRule rule, ProgramNode... children) {
    return node(new Until(rule), children);
  }

  private static ProgramNode distance(double distanceM, ProgramNode... children) {
    return until(new UntilRule.Distance(distanceM), children);
  }

  private static ProgramNode contact(double retractM, ProgramNode... children) {
    return until(new UntilRule.Contact(retractM, 3), children);
  }

  @Test
  void theDistanceIsExactAndTheLineStraight() {
    ArmRun run =
        new ArmRun(program(moveL(direction("Base", 3, 0, -4, 0.2, distance(0.1, say("there"))))));
    while (run.running()) {
      run.advance(1);
      Pose moved = run.moved();
      assertEquals(moved.x() / 3, moved.z() / -4, 1e-6);
      assertEquals(0, moved.y(), 1e-6);
    }
    run.finish();
    assertEquals(0, run.distance(0.06, 0, -0.08), 1e-6);
    assertEquals(List.of("there"), run.said());
  }

  @Test
  void itGoesAlongTheAxesOfTheTool() {
    ArmRun run = new ArmRun(program(moveL(direction("Tool", 0, 0, 1, 0.2, distance(0.05)))));
    run.finish();
    assertEquals(-0.05, run.moved().z(), 1e-5);
  }

  @Test
  void itGoesAlongTheAxesOfAFeature() {
    Feature turned =
        new Feature(
            "turned",
            FeatureKind.POINT,
            List.of(new Pose(0.1, 0.2, 0.3, 0, 0, Math.PI / 2)),
            false,
            true);
    Installation installation = ArmRun.installation(List.of(turned), List.of());
    ArmRun run =
        new ArmRun(
            program(moveL(direction("turned", 1, 0, 0, 0.2, distance(0.05)))),
            installation,
            ControllerOptions.headless());
    run.finish();
    assertEquals(0, run.distance(0, 0.05, 0), 1e-6);
  }

  @Test
  void anExpressionMaySayTheDirection() {
    ArmRun run =
        new ArmRun(
            program(
                node(new ActionStep.Assignment("way", "[[0, 0, 1], [0, 3, -4]]")),
                moveL(
                    node(
                        new Direction(
                            WaypointPosition.BASE,
                            0,
                            0,
                            0,
                            "way[1]",
                            OptionalDouble.of(0.2),
                            OptionalDouble.of(1)),
                        distance(0.05)))));
    run.finish();
    assertEquals(0, run.distance(0, 0.03, -0.04), 1e-6);
  }

  @Test
  void theShortestOfSeveralDistancesEndsIt() {
    ArmRun run =
        new ArmRun(
            program(moveL(down(0.2, distance(0.08, say("far")), distance(0.03, say("near"))))));
    run.finish();
    assertEquals(List.of("near"), run.said());
    assertEquals(0, run.distance(0, 0, -0.03), 1e-6);
  }

  @ParameterizedTest
  @CsvSource({"0", "0.02", "-0.001"})
  void aContactEndsItAndTheToolGoesBackFromWhereItTouched(double retractM) {
    ArmRun run =
        new ArmRun(
            program(moveL(down(0.05, contact(retractM, say("touched"))))), ArmRun.table(0.05));
    double[] most = new double[1];
    while (run.running()) {
      run.advance(1);
      most[0] = Math.max(most[0], run.pressN());
    }
    run.finish();
    assertTrue(most[0] > 5, () -> "pressed with " + most[0]);
    assertEquals(List.of("touched"), run.said());
    // the joint positions are looked up when the tool rests, as many frames back as before the stop
    assertEquals(0, run.distance(0, 0, -0.05 + retractM), 6e-4);
  }

  @Test
  void withoutAContactTheDistanceEndsIt() {
    ArmRun run =
        new ArmRun(
            program(
                moveL(
                    down(0.05, contact(0, say("touched")), distance(0.03, say("nothing there"))))),
            ArmRun.table(0.05));
    run.finish();
    assertEquals(List.of("nothing there"), run.said());
    assertEquals(0, run.distance(0, 0, -0.03), 1e-6);
  }

  @Test
  void anInputEndsItAtOnce() {
    ArmRun run =
        new ArmRun(
            program(
                moveL(
                    down(
                        0.1,
                        until(
                            new UntilRule.DigitalInput("digital_in[2]", true), output(1, true))))));
    run.advance(250);
    assertTrue(run.moved().z() < -0.03 && run.running());
    double before = run.moved().z();
    run.done(new IoCommand.SetInput("digital_in[2]", true));
    run.finish();
    assertTrue(run.output(1));
    // 0.1 m/s is stopped with 1 m/s² within 5 mm
    assertEquals(before - 0.005, run.moved().z(), 1e-3);
  }

  @Test
  void anExpressionEndsIt() {
    ArmRun run =
        new ArmRun(
            program(
                moveL(
                    down(
                        0.1,
                        until(
                            new UntilRule.Expression(
                                "get_target_tcp_pose()[2] < " + (ArmRun.HERE.z() - 0.04)),
                            say("low"))))));
    run.finish();
    assertEquals(List.of("low"), run.said());
    assertEquals(-0.045, run.moved().z(), 1e-3);
  }

  @Test
  void suppressedEndsDoNotCount() {
    ArmRun run =
        new ArmRun(
            program(
                moveL(
                    down(
                        0.2,
                        suppressed(distance(0.01)),
                        distance(0.05, suppressed(say("no")), say("yes"))))));
    run.finish();
    assertEquals(0, run.distance(0, 0, -0.05), 1e-6);
    assertEquals(List.of("yes"), run.said());
  }

  @Test
  void aDirectionInALoopRunsEachTime() {
    ProgramTree tree =
        tree(
            node(
                new Section.MainProgram(true),
                moveL(down(0.2, distance(0.03)), direction("Base", 0, 0, 1, 0.2, distance(0.03))),
                say("round")));
    ArmRun run = new ArmRun(tree);
    for (int i = 0; i < 6000 && run.said().size() < 3; i++) {
      run.advance(1);
      assertTrue(run.moved().z() > -0.0301);
    }
    assertEquals(List.of("round", "round", "round"), run.said());
  }

  private static ProgramNode waypoint(ProgramNode... untils) {
    return node(
        new Waypoint(
            new WaypointTarget.Fixed("goal"), new Timing.Own(0.1, 1), OptionalDouble.empty()),
        untils);
  }

  private static ProgramTree withGoal(ProgramNode... nodes) {
    return program(nodes).withWaypoint("goal", ArmRun.place(0, 0, -0.1));
  }

  @Test
  void theWayToAWaypointEndsThereIfNothingElseEndsIt() {
    ArmRun run =
        new ArmRun(
            withGoal(
                moveL(waypoint(until(new UntilRule.Expression("False"), say("no")))), say("on")));
    run.finish();
    assertEquals(0, run.distance(0, 0, -0.1), 1e-6);
    assertEquals(List.of("on"), run.said());
  }

  @Test
  void aContactEndsTheWayToAWaypoint() {
    ArmRun run =
        new ArmRun(withGoal(moveL(waypoint(contact(0.01, say("touched"))))), ArmRun.table(0.04));
    run.finish();
    assertEquals(List.of("touched"), run.said());
    assertEquals(0, run.distance(0, 0, -0.03), 2e-3);
  }

  @Test
  void aDistanceEndsTheWayToAWaypoint() {
    ArmRun run = new ArmRun(withGoal(moveL(waypoint(distance(0.06, say("far enough"))))));
    run.finish();
    assertEquals(List.of("far enough"), run.said());
    assertEquals(-0.06, run.moved().z(), 1e-3);
  }

  @Test
  void anInputEndsAMoveOfTheJoints() {
    ArmRun run =
        new ArmRun(
            withGoal(
                moveJ(
                    waypoint(
                        until(new UntilRule.DigitalInput("digital_in[0]", true), say("in"))))));
    run.advance(200);
    run.done(new IoCommand.SetInput("digital_in[0]", true));
    run.finish();
    assertEquals(List.of("in"), run.said());
    assertTrue(run.moved().z() > -0.09, run::toString);
  }
}
