package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.script;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TemplateStep.Palletizing;
import org.pendant.project.program.TemplateStep.Part;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternPoint;
import org.pendant.project.program.TemplateStep.PatternRole;
import org.pendant.project.program.WaypointPosition;
import org.pendant.script.value.Value;

/** Palletizing goes to each place of its pattern in turn. */
final class PalletRunTest {

  private static ProgramNode pallet(Pattern pattern, ProgramNode... children) {
    return node(new Palletizing("pallet", pattern, WaypointPosition.BASE, false), children);
  }

  private static ProgramNode point(PatternRole role, String waypoint) {
    return node(new PatternPoint(role, waypoint, MoveKind.LINEAR, 1, 4, OptionalDouble.empty()));
  }

  private static ProgramNode part(PartKind kind, ProgramNode... children) {
    return node(new Part(kind), children);
  }

  private static ProgramNode times(int count, ProgramNode... children) {
    return node(new FlowStep.Loop(new LoopRule.Times(String.valueOf(count), "")), children);
  }

  /** Corners of a box of 60 x 40 x 20 mm in front of the arm, and what is taught at one place. */
  private static ProgramTree taught(ProgramTree tree) {
    ProgramTree all = tree;
    for (int i = 0; i < 8; i++) {
      all =
          all.withWaypoint(
              "c" + i,
              ArmRun.place(
                  (i & 1) == 0 ? 0 : 0.06, (i & 2) == 0 ? 0 : 0.04, (i & 4) == 0 ? -0.05 : -0.03));
    }
    return all.withWaypoint("reference", ArmRun.place(0.2, 0.1, 0))
        .withWaypoint("above", ArmRun.place(0.2, 0.1, 0.03))
        .withWaypoint("away", ArmRun.place(0.2, 0.12, 0));
  }

  /** Runs a pattern that often, and tells where it has been, mm from the start. */
  private static List<String> places(Pattern pattern, int times) {
    ProgramTree tree =
        taught(
            TestTrees.program(
                times(
                    times, pallet(pattern, point(PatternRole.POINT, "reference"), say("place")))));
    return visited(new ArmRun(tree), times);
  }

  private static List<String> visited(ArmRun run, int times) {
    List<String> places = new ArrayList<>();
    int before = 0;
    while (run.running() && places.size() < times) {
      run.advance(1);
      if (run.said().size() > before) {
        before = run.said().size();
        places.add(millimetres(run));
      }
    }
    run.finish();
    return places;
  }

  private static String millimetres(ArmRun run) {
    return Math.round(1000 * run.moved().x())
        + " "
        + Math.round(1000 * run.moved().y())
        + " "
        + Math.round(1000 * run.moved().z());
  }

  @Test
  void aLineIsGoneAlongFromTheFirstToTheLastAndBeginsAgain() {
    assertEquals(
        List.of("0 0 -50", "20 0 -50", "40 0 -50", "60 0 -50", "0 0 -50"),
        places(new Pattern.Line("c0", "c1", 4), 5));
  }

  @Test
  void aSquareIsGoneThroughRowByRow() {
    assertEquals(
        List.of("0 0 -50", "30 0 -50", "60 0 -50", "0 40 -50", "30 40 -50", "60 40 -50", "0 0 -50"),
        places(new Pattern.Square(List.of("c0", "c1", "c2", "c3"), 3, 2), 7));
  }

  @Test
  void aSquareOfOneColumnIsALine() {
    assertEquals(
        List.of("0 0 -50", "0 20 -50", "0 40 -50"),
        places(new Pattern.Square(List.of("c0", "c1", "c2", "c3"), 1, 3), 3));
  }

  @Test
  void aBoxIsGoneThroughLayerByLayer() {
    List<String> corners = List.of("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7");
    List<String> expected = new ArrayList<>();
    for (int z : List.of(-50, -40, -30)) {
      for (int y : List.of(0, 40)) {
        for (int x : List.of(0, 60)) {
          expected.add(x + " " + y + " " + z);
        }
      }
    }
    expected.add("0 0 -50");
    assertEquals(expected, places(new Pattern.Box(corners, 2, 2, 3), 13));
  }

  @Test
  void aListIsGoneThroughInItsOrder() {
    assertEquals(
        List.of("60 40 -30", "0 0 -50", "60 0 -50", "60 40 -30"),
        places(new Pattern.Places(List.of("c7", "c0", "c1")), 4));
    assertEquals(List.of("60 40 -30", "60 40 -30"), places(new Pattern.Places(List.of("c7")), 2));
  }

  @Test
  void approachAndExitLieToEachPlaceAsTheyWereTaught() {
    ProgramTree tree =
        taught(
            TestTrees.program(
                times(
                    2,
                    pallet(
                        new Pattern.Line("c0", "c1", 2),
                        point(PatternRole.APPROACH, "above"),
                        say("approach"),
                        point(PatternRole.POINT, "reference"),
                        say("place"),
                        point(PatternRole.EXIT, "away"),
                        say("exit")))));
    assertEquals(
        List.of("0 0 -20", "0 0 -50", "0 20 -50", "60 0 -20", "60 0 -50", "60 20 -50"),
        visited(new ArmRun(tree), 6));
  }

  @Test
  void partsRunBeforeTheFirstAndAfterTheLastPlace() {
    ProgramTree tree =
        taught(
            TestTrees.program(
                times(
                    3,
                    pallet(
                        new Pattern.Line("c0", "c1", 2),
                        part(PartKind.BEFORE_START, say("before")),
                        part(PartKind.AFTER_END, say("after")),
                        part(
                            PartKind.SEQUENCE,
                            point(PatternRole.POINT, "reference"),
                            script("textmsg(pallet_count)"))))));
    ArmRun run = new ArmRun(tree).finish();
    assertEquals(List.of("before", "0", "1", "after", "before", "0"), run.said());
    assertEquals(Value.of(1), run.variable("pallet_count"));
  }

  @Test
  void aRememberedCountIsThatOfTheInstallation() {
    Installation installation =
        ArmRun.installation()
            .withVariables(List.of(new InstallationVariable("pallet_count", "2", false)));
    ProgramTree tree =
        taught(
            TestTrees.program(
                node(
                    new Palletizing(
                        "pallet", new Pattern.Line("c0", "c1", 4), WaypointPosition.BASE, true),
                    point(PatternRole.POINT, "reference"))));
    ArmRun run = new ArmRun(tree, installation, ControllerOptions.headless()).finish();
    assertEquals("40 0 -50", millimetres(run));
    assertEquals(Value.of(3), run.variable("pallet_count"));
  }

  @Test
  void aPlaceMayBeTurned() {
    WaypointPosition first = ArmRun.place(0, 0, -0.05);
    ProgramTree tree =
        taught(
                TestTrees.program(
                    pallet(
                        new Pattern.Places(List.of("turned")),
                        point(PatternRole.POINT, "reference"),
                        point(PatternRole.EXIT, "away"))))
            .withWaypoint(
                "turned",
                new WaypointPosition(
                    Poses.trans(first.tcp(), new Pose(0, 0, 0, 0, 0, Math.PI / 2)),
                    first.feature(),
                    first.jointsRad(),
                    first.toolInFlange()));
    ArmRun run = new ArmRun(tree).finish();
    // 20 mm along y of the base at the reference are so many along x when the tool is turned
    assertEquals(0.02, Math.abs(run.moved().x()), 1e-5);
    assertEquals(0, run.moved().y(), 1e-5);
    assertTrue(run.said().isEmpty());
  }
}
