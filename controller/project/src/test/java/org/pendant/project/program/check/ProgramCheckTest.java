package org.pendant.project.program.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;
import org.pendant.project.program.text.RandomTrees;

/** What keeps trees from running, told at the field. */
final class ProgramCheckTest {
  private static final OptionalDouble NONE = OptionalDouble.empty();

  private static ProgramTree sections(ProgramNode... sections) {
    return new ProgramTree("", Map.of(), List.of(), 1)
        .insert(ProgramTree.ROOT, 0, List.of(sections))
        .withWaypoint("A", place(0.3))
        .withWaypoint("B", place(0.4));
  }

  private static ProgramTree program(ProgramNode... children) {
    return sections(node(new Section.MainProgram(false), children));
  }

  private static WaypointPosition place(double x) {
    return new WaypointPosition(
        new Pose(x, 0, 0.3, 0, 3.14, 0), WaypointPosition.BASE, Joints.ZERO, Pose.ZERO);
  }

  private static ProgramNode move(MoveKind kind, ProgramNode... children) {
    return node(
        new MotionStep.Move(kind, 0.5, 1, new ToolChoice.Active(), WaypointPosition.BASE, false),
        children);
  }

  private static ProgramNode waypoint(String name) {
    return blended(name, NONE);
  }

  private static ProgramNode blended(String name, OptionalDouble radius) {
    return node(
        new MotionStep.Waypoint(new WaypointTarget.Fixed(name), new Timing.AsMove(), radius));
  }

  private static ProgramNode assign(String variable, String expression) {
    return node(new ActionStep.Assignment(variable, expression));
  }

  private static ProgramNode set(Setting setting) {
    return node(new ActionStep.SetAction(setting));
  }

  /** Each problem as {@code line field: message}. */
  private static List<String> problems(ProgramTree tree) {
    return problems(tree, Installation.NONE);
  }

  private static List<String> problems(ProgramTree tree, Installation installation) {
    List<Long> keys = tree.nodes().stream().map(ProgramNode::key).toList();
    return ProgramCheck.problems(tree, installation).stream()
        .map(each -> (keys.indexOf(each.key()) + 1) + " " + each.field() + ": " + each.message())
        .toList();
  }

  @Test
  void namesThatADriverMaySendAreMissingOnlyWhereNoneIsAsked() {
    ProgramNode uses =
        node(new ActionStep.ScriptFile("own.script", List.of("their_function(their_variable)")));
    ForeignStep.Contributed control =
        new ForeignStep.Contributed("FZI", "External Control", List.of("<x/>"), List.of());
    assertEquals(List.of(), problems(program(node(control), uses)));
    assertFalse(problems(program(uses)).isEmpty());
    assertFalse(problems(program(node(control).withSuppressed(true), uses)).isEmpty());
    assertFalse(
        problems(program(node(control), node(new ActionStep.ScriptLine("sleep(")))).isEmpty());
  }

  private static void assertProblem(String expected, ProgramNode... nodes) {
    assertEquals(List.of(expected), problems(program(nodes)));
  }

  private static void assertProblem(String expected, Step step, ProgramNode... below) {
    assertProblem("2 " + expected, node(step, below));
  }

  private static void assertFine(ProgramNode... nodes) {
    assertEquals(List.of(), problems(program(nodes)));
  }

  @Test
  void aCompleteProgramHasNoProblems() {
    assertFine(
        move(MoveKind.JOINT, waypoint("A"), blended("B", OptionalDouble.of(0.02)), waypoint("A")),
        assign("count", "1"),
        node(
            new FlowStep.If("count > 0 and get_standard_digital_in(0)", false),
            set(new Setting.Digital("digital_out[1]", true))),
        node(new FlowStep.ElseIf("count == 3"), node(new ActionStep.Halt())),
        node(new FlowStep.Else(), node(new ActionStep.Wait(new WaitFor.Time(1)))),
        assign("place", "A_p"));
    assertEquals(List.of(), problems(ProgramTree.empty()));
  }

  @Test
  void waypointsMustBeTaught() {
    assertProblem("3 target: C has not been taught yet", move(MoveKind.JOINT, waypoint("C")));
    assertProblem("3 target: a waypoint has no name", move(MoveKind.JOINT, waypoint("")));
  }

  @Test
  void whatIsMissingInTheInstallationIsNamed() {
    assertProblem(
        "tool: the installation has no TCP 'gripper'",
        new MotionStep.Move(
            MoveKind.LINEAR, 0.5, 1, new ToolChoice.Named("gripper"), "Base", false));
    assertProblem(
        "feature: the installation has no feature 'table'",
        new MotionStep.Move(MoveKind.LINEAR, 0.5, 1, new ToolChoice.Active(), "table", false));
    assertProblem(
        "setting: the installation has no payload 'box'",
        new ActionStep.SetAction(new Setting.NamedPayload("box")));
    assertProblem(
        "setting: the installation has no variable 'parts'",
        new ActionStep.SetAction(new Setting.Increment("parts")));
    assertProblem(
        "conveyor: the installation has no conveyor 2", new TemplateStep.ConveyorTracking(2));
  }

  @Test
  void aVariableOfTheInstallationMayBeUsed() {
    Installation installation =
        Installation.NONE.withVariables(List.of(new InstallationVariable("parts", "0", false)));
    assertEquals(
        List.of(),
        problems(
            program(assign("more", "parts + 1"), set(new Setting.Increment("parts"))),
            installation));
  }

  @ParameterizedTest
  @CsvSource({
    "'', the variable has no name",
    "2x, '''2x'' is no name, expected letters, digits and _, no digit first'",
    "while, '''while'' is a word of the language, expected another name'",
    "movej, '''movej'' is a built-in function, expected another name'",
    "part, '''part'' is a sub program, expected another name'"
  })
  void namesMustBeOfTheLanguageAndFree(String name, String message) {
    ProgramTree tree =
        sections(
            node(new Section.MainProgram(false), assign(name, "1")),
            node(new Section.SubProgram("part", "")));
    assertEquals(List.of("2 variable: " + message), problems(tree));
  }

  @ParameterizedTest
  @CsvSource({
    "'', 'the value is missing, expected an expression'",
    "'1 +', column 4",
    "'(1 + 2', column",
    "'1)', 'column 2: nothing is open that ) could close'",
    "'x = 1', 'column 3: = assigns, expected an expression; == compares'",
    "'1 # one', 'column 3: there is a comment, expected an expression alone'",
    "'while 1', column 1",
    "'\"text', column"
  })
  void expressionsThatCannotBeReadAreToldWithTheirColumn(String text, String message) {
    List<String> found = problems(program(assign("x", text), assign("y", "x + 1")));
    assertEquals(1, found.size(), found::toString);
    assertTrue(found.getFirst().startsWith("2 expression: " + message), found::toString);
  }

  @Test
  void everyWrongExpressionIsToldEvenAmongMany() {
    List<ProgramNode> nodes = new ArrayList<>();
    List<String> expected = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      nodes.add(assign("v" + i, i % 7 == 3 ? "1 2" : "1 + " + i));
      if (i % 7 == 3) {
        expected.add(String.valueOf(i + 2));
      }
    }
    List<String> found = problems(program(nodes.toArray(ProgramNode[]::new)));
    assertEquals(
        expected, found.stream().map(each -> each.substring(0, each.indexOf(' '))).toList());
  }

  @Test
  void aVariableThatNothingAssignsIsToldInItsField() {
    List<String> found = problems(program(assign("x", "1 + nothing")));
    assertEquals(1, found.size());
    assertTrue(
        found.getFirst().startsWith("2 expression: column 5: ")
            && found.getFirst().contains("nothing"),
        found::toString);
    List<String> function = problems(program(assign("x", "movjj(1)")));
    assertTrue(function.getFirst().startsWith("2 expression: column 1: "), function::toString);
  }

  @Test
  void aVariableWhoseValueIsMissingIsToldOnlyThere() {
    assertProblem(
        "2 expression: the value is missing, expected an expression",
        assign("x", ""),
        assign("y", "x + 1"));
  }

  @Test
  void aConditionThatIsNoneIsTold() {
    List<String> found = problems(program(node(new FlowStep.If("p[1, 2, 3, 4, 5, 6]", false))));
    assertEquals(1, found.size());
    assertTrue(found.getFirst().startsWith("2 condition: "), found::toString);
  }

  @Test
  void whatFailsInAPartOfAScriptThatMayNeverRunDoesNotBlock() {
    List<NodeProblem> found =
        ProgramCheck.problems(
            program(
                node(
                    new ActionStep.ScriptFile(
                        "lib.script",
                        List.of("def never():", "  textmsg(nowhere)", "  sleep()", "end")))),
            Installation.NONE);
    assertEquals(
        List.of("variable nowhere is never assigned"),
        found.stream().map(NodeProblem::message).toList());
    assertFalse(found.getFirst().blocks());
  }

  @Test
  void wrongScriptLinesAreTold() {
    List<String> found =
        problems(program(node(new ActionStep.ScriptLine("x = = 1")), assign("y", "1")));
    assertTrue(found.getFirst().startsWith("2 : "), found::toString);
    assertFine(
        node(new ActionStep.ScriptLine("while True:")),
        node(new ActionStep.ScriptLine("  sleep(1)")),
        node(new ActionStep.ScriptLine("end")));
    assertProblem("code: the script line is empty", new ActionStep.ScriptLine(" "));
    assertProblem("file: no script file is chosen", new ActionStep.ScriptFile("", List.of()));
  }

  @Test
  void signalsMustExistAndBeOfTheRightKind() {
    assertProblem(
        "setting: there is no signal 'digital_out[8]'",
        new ActionStep.SetAction(new Setting.Digital("digital_out[8]", true)));
    assertProblem(
        "setting: digital_in[0] is no digital output, cannot be set",
        new ActionStep.SetAction(new Setting.Digital("digital_in[0]", true)));
    assertProblem(
        "what: the signal is missing", new ActionStep.Wait(new WaitFor.Digital("", true)));
    assertProblem(
        "what: digital_in[0] is no analog signal",
        new ActionStep.Wait(new WaitFor.Analog("digital_in[0]", true, 1)));
    assertProblem(
        "setting: analog_in[0] is no analog output, cannot be set",
        new ActionStep.SetAction(new Setting.Analog("analog_in[0]", 1)));
    assertProblem(
        "setting: tool_in[1] cannot be set",
        new ActionStep.SetAction(new Setting.Expression("tool_in[1]", "True")));
    assertFine(
        set(new Setting.Digital("flag[31]", true)),
        set(new Setting.Expression("output_float_register[5]", "1.5")),
        node(new ActionStep.Wait(new WaitFor.Digital("configurable_in[7]", false))));
  }

  @Test
  void numbersMustBePossible() {
    assertProblem(
        "speed: speed is 0 mm/s, must be above 0 and at most 5000 mm/s",
        new MotionStep.Move(MoveKind.LINEAR, 0, 1, new ToolChoice.Active(), "Base", false));
    assertProblem(
        "acceleration: acceleration is 2864.789 deg/s², must be above 0 and at most 2291.831"
            + " deg/s²",
        new MotionStep.Move(MoveKind.JOINT, 1, 50, new ToolChoice.Active(), "Base", false));
    assertProblem(
        "what: time is -1 s, must be 0 to 1000000 s", new ActionStep.Wait(new WaitFor.Time(-1)));
    assertProblem(
        "setting: current is 30 mA, must be 4 to 20 mA",
        new ActionStep.SetAction(new Setting.Analog("analog_out[0]", 0.03)));
    assertProblem(
        "3 blendRadiusM: blend radius is -1000 mm, must be 0 to 10000 mm",
        move(MoveKind.LINEAR, blended("A", OptionalDouble.of(-1))));
    assertProblem(
        "4 rule: blend radius is 11000 mm, must be 0 to 10000 mm",
        move(
            MoveKind.LINEAR,
            node(
                new MotionStep.Direction("Base", 0, 0, 1, NONE, NONE),
                node(new MotionStep.Until(new UntilRule.Distance(0.1, OptionalDouble.of(11)))))));
    assertProblem(
        "speed: speed is -0.00012 mm/s, must be above 0 and at most 5000 mm/s",
        new MotionStep.Move(MoveKind.LINEAR, -1.2e-7, 1, new ToolChoice.Active(), "Base", false));
    assertProblem(
        "speed: speed is 360.5 deg/s, must be above 0 and at most 360 deg/s",
        new MotionStep.Move(
            MoveKind.JOINT, Math.toRadians(360.5), 1, new ToolChoice.Active(), "Base", false));
    assertProblem(
        "rule: the number of turns is -3, must not be negative",
        new FlowStep.Loop(new LoopRule.Times("-3", "")));
    assertProblem(
        "speed: speed is NaN mm/s, must be above 0 and at most 5000 mm/s",
        new MotionStep.Move(
            MoveKind.LINEAR, Double.NaN, 1, new ToolChoice.Active(), "Base", false));
  }

  @Test
  void aBlendMustFitBetweenItsWaypoints() {
    assertEquals(
        List.of(
            "4 blendRadiusM: blend radius is 150 mm, but the previous waypoint is only 100 mm away",
            "4 blendRadiusM: blend radius is 150 mm, but the next waypoint is only 100 mm away"),
        problems(
            program(
                move(
                    MoveKind.LINEAR,
                    waypoint("A"),
                    blended("B", OptionalDouble.of(0.15)),
                    waypoint("A")))));
  }

  @Test
  void elseFollowsAnIf() {
    assertProblem("Else stands directly behind an If or ElseIf", new FlowStep.Else(), ": ");
    assertProblem(
        "3 : ElseIf stands directly behind an If or ElseIf",
        node(new ActionStep.Halt()),
        node(new FlowStep.ElseIf("True")));
    assertEquals(
        List.of("4 : Else stands directly behind an If or ElseIf"),
        problems(
            program(
                node(new FlowStep.If("True", false)),
                node(new FlowStep.Else()),
                node(new FlowStep.Else()))));
    assertEquals(
        List.of("3 : Else stands directly behind an If or ElseIf"),
        problems(
            program(
                node(new FlowStep.If("True", false)).withSuppressed(true),
                node(new FlowStep.Else()))));
  }

  private static void assertProblem(String message, Step step, String separator) {
    assertProblem("2 " + separator + message, node(step));
  }

  @Test
  void aCircleHasTwoWaypoints() {
    ProgramNode circle = node(new MotionStep.CircleMove(false, NONE), waypoint("A"));
    assertProblem(
        "3 : a circle has 1 waypoints, must have 2: via and end", move(MoveKind.PROCESS, circle));
  }

  @Test
  void aSwitchHasDifferentCases() {
    assertProblem(": the Switch is empty, expected a Case below it", new FlowStep.Switch("1"));
    assertProblem(
        "4 value: there is another case 1.0",
        node(
            new FlowStep.Switch("2"),
            node(new FlowStep.Case("1")),
            node(new FlowStep.Case("1.0"))));
    assertProblem(
        "3 value: 'one' is no number",
        node(new FlowStep.Switch("2"), node(new FlowStep.Case("one"))));
  }

  @Test
  void aDirectionHasALengthAndAnEnd() {
    MotionStep.Direction nowhere = new MotionStep.Direction("Base", 0, 0, 0, NONE, NONE);
    assertEquals(
        List.of(
            "3 x: the direction has no length, one of x, y and z must be another than 0",
            "3 : nothing ends the direction, expected an Until below it"),
        problems(program(move(MoveKind.LINEAR, node(nowhere)))));
    assertProblem(
        "3 expression: column 1: variable nowhere is never assigned",
        move(
            MoveKind.LINEAR,
            node(
                new MotionStep.Direction("Base", 0, 0, 0, "nowhere", NONE, NONE),
                node(new MotionStep.Until(new UntilRule.Distance(0.1))))));
    assertProblem(
        "4 rule: distance is 0 mm, must be above 0 and at most 10000 mm",
        move(
            MoveKind.LINEAR,
            node(
                new MotionStep.Direction("Base", 0, 0, 1, NONE, NONE),
                node(new MotionStep.Until(new UntilRule.Distance(0))))));
  }

  @Test
  void nodesStandWhereTheyBelong() {
    assertProblem(
        "2 : Waypoint does not go below Main program, only below a move or a circle",
        waypoint("A"));
    assertFine(move(MoveKind.LINEAR, node(new ActionStep.Folder("f"), waypoint("A"))));
    assertFine(move(MoveKind.LINEAR, move(MoveKind.JOINT, waypoint("A"))));
    assertEquals(
        List.of("0 : there is no main program"),
        problems(sections(node(new Section.ThreadSection("t", true)))));
  }

  @Test
  void subProgramsAreFoundByTheirOwnNames() {
    assertProblem("subProgram: no sub program is chosen", new ActionStep.Call(""));
    assertProblem("subProgram: there is no sub program 'x'", new ActionStep.Call("x"));
    assertEquals(
        List.of("4 name: there are two sub programs 's'"),
        problems(
            sections(
                node(new Section.MainProgram(false), node(new ActionStep.Call("s"))),
                node(new Section.SubProgram("s", "")),
                node(new Section.SubProgram("s", "")))));
  }

  @Test
  void patternsNeedPlaces() {
    TemplateStep.Palletizing line =
        new TemplateStep.Palletizing("p", new Pattern.Line("A", "B", 1), "Base", false);
    ProgramNode point =
        node(
            new TemplateStep.PatternPoint(
                TemplateStep.PatternRole.POINT, "A", MoveKind.LINEAR, 0.5, 1, NONE));
    assertProblem("pattern: places of the line is 1, must be 2 to 1000000", line, point);
    assertEquals(
        List.of(
            "2 pattern: the pattern has 2 corners, must have 4",
            "2 remember: to keep the count, the installation must have a variable 'p_count'",
            "2 : the places are never gone to, expected a pattern point below it"),
        problems(
                program(
                    node(
                        new TemplateStep.Palletizing(
                            "p", new Pattern.Square(List.of("A", "B"), 2, 2), "Base", true))))
            .stream()
            .sorted(
                Comparator.comparing((String each) -> !each.contains("pattern:"))
                    .thenComparing(each -> !each.contains("remember")))
            .toList());
  }

  @Test
  void forcesHaveLimits() {
    List<Double> limits = List.of(0.1, 0.1, 0.0, 0.3, 0.3, 0.3);
    assertEquals(
        List.of(
            "2 wrench: force along z is 900 N, must be -500 to 500 N",
            "2 limits: speed limit of z is 0 mm/s, must be above 0 and at most 10000 mm/s"),
        problems(
            program(
                node(
                    new TemplateStep.Force(
                        TemplateStep.ForceKind.SIMPLE,
                        "Base",
                        List.of(false, false, true, false, false, false),
                        List.of(0.0, 0.0, 900.0, 0.0, 0.0, 0.0),
                        limits)))));
  }

  @Test
  void suppressedNodesAreNotLookedAt() {
    assertFine(
        assign("", "1 +").withSuppressed(true),
        node(new ActionStep.Folder("f"), waypoint("C")).withSuppressed(true));
  }

  @Test
  void unknownNodesAreRemarkedOnButDoNotBlock() {
    List<NodeProblem> found =
        ProgramCheck.problems(
            program(node(new ForeignStep.Unknown("Gripper", List.of("<Gripper/>")))),
            Installation.NONE);
    assertEquals(1, found.size());
    assertFalse(found.getFirst().blocks());
    assertEquals("Pendant does not know 'Gripper': it does nothing", found.getFirst().message());
  }

  @ParameterizedTest
  @ValueSource(strings = {"thread", "end", "1, 2", "x: y", "\u00e4", "a\nb", "\"", "]", ";"})
  void noTextMakesTheCheckFail(String text) {
    ProgramTree tree =
        sections(
            node(
                new Section.MainProgram(true),
                node(new FlowStep.If(text, true), assign(text, text)),
                node(new FlowStep.Loop(new LoopRule.While(text, true)), waypoint(text)),
                node(new ActionStep.Popup(text, true, ActionStep.PopupKind.ERROR, false))),
            node(new Section.ThreadSection(text, true)),
            node(new Section.Event(text)));
    List<String> found = problems(tree);
    assertTrue(found.stream().anyMatch(each -> each.startsWith("2 condition: ")), found::toString);
    assertTrue(found.stream().anyMatch(each -> each.startsWith("3 variable: ")), found::toString);
  }

  @Test
  void anyTreeIsCheckedAndToldOnlyAboutItsNodes() {
    for (long seed = 0; seed < 150; seed++) {
      ProgramTree tree = new RandomTrees(seed).tree();
      for (NodeProblem each : ProgramCheck.problems(tree, Installation.NONE)) {
        String found = "seed " + seed + ": " + each;
        assertFalse(each.message().isBlank(), found);
        assertTrue(each.key() == ProgramTree.ROOT || tree.find(each.key()).isPresent(), found);
      }
    }
  }
}
