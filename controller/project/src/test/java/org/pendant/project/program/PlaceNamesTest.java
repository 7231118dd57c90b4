package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.check.ProgramCheck;
import org.pendant.project.program.script.ScriptGenerator;

/** Calling taught places otherwise. */
final class PlaceNamesTest {
  private static final OptionalDouble NONE = OptionalDouble.empty();

  private static WaypointPosition position(double x) {
    return new WaypointPosition(
        new Pose(x, 0, 0.3, 0, 3.14, 0), WaypointPosition.BASE, Joints.ZERO, Pose.ZERO);
  }

  private static ProgramNode waypoint(WaypointTarget target) {
    return node(new MotionStep.Waypoint(target, new Timing.AsMove(), NONE));
  }

  private static ProgramTree program(ProgramNode... nodes) {
    ProgramTree tree = ProgramTree.empty();
    return tree.insert(tree.sections().getFirst().key(), 0, List.of(nodes))
        .withWaypoint("A", position(0.5))
        .withWaypoint("B", position(0.4));
  }

  private static Step first(ProgramTree tree) {
    return tree.find(2).orElseThrow().step();
  }

  private static Step renamed(Step step) {
    return first(PlaceNames.renamed(program(node(step)), "A", "Pick"));
  }

  private static String code(String code, String from, String to) {
    ProgramTree tree = program(node(new ActionStep.ScriptLine(code)));
    return ((ActionStep.ScriptLine) first(PlaceNames.renamed(tree, from, to))).code();
  }

  @Test
  void placesKeepTheirOrderAndPositions() {
    ProgramTree next = PlaceNames.renamed(program(), "A", "Pick");
    assertEquals(List.of("Pick", "B"), List.copyOf(next.waypoints().keySet()));
    assertEquals(position(0.5), next.waypoints().get("Pick"));
    assertSame(next, PlaceNames.renamed(next, "Pick", "Pick"));
    assertSame(next, PlaceNames.renamed(next, "", "C"));
  }

  @Test
  void whatGetsTheNameOfAnotherPlaceGoesThere() {
    ProgramTree tree = program(waypoint(new WaypointTarget.Fixed("A")));
    ProgramTree next = PlaceNames.renamed(tree, "A", "B");
    assertEquals(Map.of("B", position(0.4)), next.waypoints());
    assertEquals(waypoint(new WaypointTarget.Fixed("B")).step(), first(next));
  }

  @Test
  void everyStepThatNamesAPlaceFollows() {
    assertEquals(
        new WaypointTarget.Relative("A", "Pick", "B"),
        ((MotionStep.Waypoint) renamed(waypoint(new WaypointTarget.Relative("A", "A", "B")).step()))
            .target());
    assertEquals(
        List.of("Pick", "B", "Pick", "B"),
        TreeNames.waypoints(
            renamed(
                new TemplateStep.Palletizing(
                    "p", new Pattern.Square(List.of("A", "B", "A", "B"), 2, 2), "Base", false))));
    assertEquals(
        List.of("Pick"),
        TreeNames.waypoints(
            renamed(
                new TemplateStep.PatternPoint(
                    TemplateStep.PatternRole.POINT, "A", MoveKind.LINEAR, 0.5, 1, NONE))));
    TemplateStep.Seek seek =
        new TemplateStep.Seek(
            true, "s", "A", "Base", List.of(0.0, 0.0, 1.0), 0.1, 0.02, "A_p[2] > 0", 0.1, 1);
    TemplateStep.Seek there = (TemplateStep.Seek) renamed(seek);
    assertEquals("Pick", there.start());
    assertEquals("Pick_p[2] > 0", there.found());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '\'',
      value = {
        "movel(A_p) # A_p|movel(Pick_p) # A_p",
        "x = pose_trans(A_p, B_p)|x = pose_trans(Pick_p, B_p)",
        "movej(A_q, a=1)|movej(Pick_q, a=1)",
        "textmsg(\"A_p is \", A_p)|textmsg(\"A_p is \", Pick_p)",
        "AA_p = A_pp + s.A_p|AA_p = A_pp + s.A_p",
        "textmsg(\"é\", A_p, \"ö\")|textmsg(\"é\", Pick_p, \"ö\")",
        "A = 1|A = 1",
        "x = \"A_p|x = \"A_p",
      })
  void codeFollowsWordByWord(String before, String after) {
    assertEquals(after, code(before, "A", "Pick"));
  }

  @Test
  void variablesFollowTheNamesThatTheScriptGivesThem() {
    assertEquals("movel(Grobe_Ku237ste_p)", code("movel(A_p)", "A", "Grobe Kíste"));
    // of two places whose words are alike the later one has a number
    ProgramTree both =
        program(node(new ActionStep.ScriptLine("movel(x_y_p) movel(x_y_2_p)")))
            .withWaypoint("x y", position(1))
            .withWaypoint("x_y", position(2));
    ProgramTree next = PlaceNames.renamed(both, "x y", "C");
    assertEquals(new ActionStep.ScriptLine("movel(C_p) movel(x_y_p)"), first(next));
  }

  @Test
  void expressionsFollowAndTheProgramStillRuns() {
    ProgramTree tree =
        program(
            node(new ActionStep.Assignment("where", "pose_trans(A_p, p[0, 0, 0.1, 0, 0, 0])")),
            node(
                new MotionStep.Move(
                    MoveKind.LINEAR, 0.5, 1, new ToolChoice.Active(), "Base", false),
                waypoint(new WaypointTarget.Fixed("A")),
                waypoint(new WaypointTarget.Variable("A_p"))));
    assertEquals(List.of(), ProgramCheck.problems(tree, Installation.NONE));
    ProgramTree next = PlaceNames.renamed(tree, "A", "A 2");
    assertEquals(List.of(), ProgramCheck.problems(next, Installation.NONE));
    assertTrue(
        ScriptGenerator.generate("p", next, Installation.NONE)
            .text()
            .contains("where = pose_trans(A_2_p, p[0, 0, 0.1, 0, 0, 0])"));
  }

  @Test
  void scriptFilesStayAsTheyAre() {
    Step file = new ActionStep.ScriptFile("a.script", List.of("movel(A_p)"));
    assertEquals(file, renamed(file));
    assertEquals(
        new ActionStep.ScriptFile("", List.of("movel(Pick_p)")),
        renamed(new ActionStep.ScriptFile("", List.of("movel(A_p)"))));
  }

  @Test
  void nodesOfAnotherProgramFollowAMap() {
    ProgramNode folder =
        node(
            new ActionStep.Folder("A"),
            waypoint(new WaypointTarget.Fixed("A")),
            node(new ActionStep.Assignment("x", "A_p[0] + B_p[0]")));
    assertEquals(
        node(
            new ActionStep.Folder("A"),
            waypoint(new WaypointTarget.Fixed("A_1")),
            node(new ActionStep.Assignment("x", "A_1_p[0] + B_p[0]"))),
        PlaceNames.renamed(folder, Map.of("A", "A_1", "B", "B")));
  }
}
