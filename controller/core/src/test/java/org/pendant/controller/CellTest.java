package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.io.Signal;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MovedObject;
import org.pendant.language.source.Source;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

final class CellTest {
  private static final String FACING =
      """
      "arms": [
        {"name": "left"},
        {"name": "right", "base": [1.2, 0, 0, 0, 0, 3.141592653589793]}
      ]\
      """;

  /** A bar of 140 x 140 x 400 mm with its origin in its middle. */
  private static final String BAR =
      """
      v -70 -70 -200
      v 70 -70 -200
      v 70 70 -200
      v -70 70 -200
      v -70 -70 200
      v 70 -70 200
      v 70 70 200
      v -70 70 200
      f 4 3 2 1
      f 5 6 7 8
      f 1 2 6 5
      f 2 3 7 6
      f 3 4 8 7
      f 4 1 5 8
      """;

  @TempDir Path folder;

  private static Cell cell(String members) throws JsonException {
    return cell(members, ControllerOptions.headless());
  }

  private static Cell cell(String members, ControllerOptions each) throws JsonException {
    byte[] file = ("{" + members + "}").getBytes(StandardCharsets.UTF_8);
    return cell(CellPlan.read("cell.json", new ByteArrayInputStream(file), MeshFiles.NONE), each);
  }

  private static Cell cell(CellPlan plan, ControllerOptions each) throws JsonException {
    List<ControllerOptions> options = new ArrayList<>();
    plan.layout().names().forEach(_ -> options.add(each));
    return new Cell(plan, options, StandardBuiltins.create());
  }

  private static Controller controller(Cell cell, String name) {
    return cell.members().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow()
        .controller();
  }

  private static ControllerState state(Cell cell, String name) {
    return controller(cell, name).state();
  }

  private static void start(Cell cell, String name, String... lines) {
    String text = "def " + name + "():\n  " + String.join("\n  ", lines) + "\nend\n";
    Controller on = controller(cell, name);
    LoadResult loaded = on.load(Source.of(name + ".script", text));
    var _ =
        on.submit(
            new ProgramCommand.StartProgram(loaded.program().orElseThrow(), Optional.empty()));
  }

  private static void runUntilStopped(Cell cell, String name, int maxFrames) {
    for (int i = 0; i < maxFrames; i++) {
      cell.advance();
      if (i > 0 && state(cell, name).program().state() == ProgramState.STOPPED) {
        return;
      }
    }
    throw new AssertionError(name + " still runs");
  }

  private static Pose bodyOf(Cell cell, String name) {
    MovedObject moved = state(cell, name).moved().getFirst();
    return moved.poseInBase();
  }

  @Test
  void aWireLeadsASignalOnInTheNextFrame() throws JsonException {
    Cell cell = cell(FACING + ", \"wires\": [[\"left.digital_out[0]\", \"right.digital_in[3]\"]]");
    start(cell, "left", "set_standard_digital_out(0, True)", "sleep(1)");
    cell.advance();
    assertTrue(state(cell, "left").io().level(Signal.named("digital_out[0]")));
    assertFalse(state(cell, "right").io().level(Signal.named("digital_in[3]")));
    cell.advance();
    assertTrue(state(cell, "right").io().level(Signal.named("digital_in[3]")));
  }

  @Test
  void aRuleJoinsSignalsOfTwoArms() throws JsonException {
    Cell cell =
        cell(
            FACING
                + """
                , "rules": [
                  {"while": "left.digital_out[0] and right.digital_out[0] is off",
                   "set": "right.digital_in[1]"}
                ]\
                """);
    start(cell, "left", "set_standard_digital_out(0, True)", "sleep(1)");
    cell.advance();
    cell.advance();
    assertTrue(state(cell, "right").io().level(Signal.named("digital_in[1]")));
    start(cell, "right", "set_standard_digital_out(0, True)", "sleep(1)");
    cell.advance();
    cell.advance();
    assertFalse(state(cell, "right").io().level(Signal.named("digital_in[1]")));
  }

  @Test
  void aPlainSignalIsThatOfTheFirstArm() throws JsonException {
    Cell cell = cell(FACING + ", \"rules\": [{\"every\": 1, \"set\": \"digital_in[2]\"}]");
    cell.advance();
    assertTrue(state(cell, "left").io().level(Signal.named("digital_in[2]")));
    assertFalse(state(cell, "right").io().level(Signal.named("digital_in[2]")));
  }

  @Test
  void theCellsScriptHasSignalsOfItsOwn() throws JsonException {
    Cell cell =
        cell(
            "\"script\": \"plc.script\", \"wires\": [[\"arm.digital_out[0]\","
                + " \"cell.digital_in[0]\"], [\"cell.digital_out[0]\", \"arm.digital_in[0]\"]]");
    start(cell, "arm", "set_standard_digital_out(0, True)", "sleep(1)");
    start(
        cell,
        "cell",
        "while not get_standard_digital_in(0):",
        "  sync()",
        "end",
        "set_standard_digital_out(0, True)");
    runUntilStopped(cell, "cell", 20);
    cell.advance();
    assertTrue(state(cell, "arm").io().level(Signal.named("digital_in[0]")));
  }

  @Test
  void theCellsScriptCannotMoveAnArm() throws JsonException {
    Cell cell = cell("\"script\": \"plc.script\"");
    LoadResult loaded =
        controller(cell, "cell")
            .load(Source.of("plc.script", "def plc():\n  movej([0, 0, 0, 0, 0, 0])\nend\n"));
    assertTrue(loaded.program().isEmpty());
    assertEquals(
        "function movej needs an arm, and the cell's controller has none",
        loaded.diagnostics().getFirst().message());
  }

  @Test
  void aLinkThatGetsIntoAnotherArmStopsBoth() throws JsonException {
    Cell cell =
        cell(
            """
            "arms": [
              {"name": "left", "start": [1.5, -1.5708, -1.5708, -1.5708, 1.5708, 0]},
              {"name": "right", "base": [1, 0, 0, 0, 0, 3.141592653589793]}
            ]\
            """);
    start(cell, "left", "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])");
    for (int i = 0; i < 3000 && state(cell, "left").safety().stop().isEmpty(); i++) {
      cell.advance();
    }
    assertTrue(
        state(cell, "left").safety().stop().orElseThrow().message().contains("of right"),
        () -> state(cell, "left").safety().stop().orElseThrow().message());
    cell.advance();
    SafetyStop left = state(cell, "left").safety().stop().orElseThrow();
    SafetyStop right = state(cell, "right").safety().stop().orElseThrow();
    assertTrue(right.message().contains("of left"), right::message);
    assertEquals(right.hitLinks(), left.hitLinkOf("right").stream().toList());
    assertEquals(left.hitLinks(), right.hitLinkOf("left").stream().toList());
    assertEquals(Optional.empty(), left.hitLinkOf("ight"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"type\": \"box\", \"pose\": [0, 0, 0.2, 0, 0, 0], \"size\": [0.14, 0.14, 0.4]",
        "\"type\": \"cylinder\", \"pose\": [0, 0, 0.2, 0, 0, 0], \"radius\": 0.07, \"length\": 0.4",
        "\"type\": \"mesh\", \"pose\": [0, 0, 0.2, 0, 0, 0], \"mesh\": \"bar.obj\", \"unit\":"
            + " \"mm\""
      })
  void bodiesOfTwoToolsThatHitOneAnotherStopBothArms(String body) throws Exception {
    Files.writeString(folder.resolve("bar.obj"), BAR);
    String tool =
        "\"tool\": [{\"name\": \"long\", "
            + body
            + "}], \"start\": [0, -1.5708, -1.5708, -1.5708, 1.5708, 0]";
    String text =
        "{\"arms\": [{\"name\": \"left\", "
            + tool
            + "}, {\"name\": \"right\", \"base\": [1.16, -0.267, 0, 0, 0, 3.141592653589793], "
            + tool
            + "}]}";
    CellPlan plan =
        CellPlan.read(
            "cell.json",
            new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
            MeshFiles.in(folder));
    Cell cell = cell(plan, ControllerOptions.headless());
    assertTrue(nearestM(cell, "left") > 0.01);
    start(cell, "left", "movel(pose_add(get_actual_tcp_pose(), p[0.1, 0, 0, 0, 0, 0]))");
    for (int i = 0; i < 3000 && state(cell, "left").safety().stop().isEmpty(); i++) {
      cell.advance();
    }
    cell.advance();
    SafetyStop stop = state(cell, "left").safety().stop().orElseThrow();
    assertEquals("the tool has hit the tool of right", stop.sentence());
    assertEquals(
        "the tool has hit the tool of left",
        state(cell, "right").safety().stop().orElseThrow().sentence());
    assertTrue(stop.value() < 0.003, stop::message);
  }

  @Test
  void anArmWhoseBaseIsHitStopsAsWell() throws JsonException {
    Cell cell =
        cell(
            """
            "arms": [
              {"name": "left", "start": [0.5, 0.3, -0.3, -1.5708, 1.5708, 0]},
              {"name": "right", "base": [-0.8, 0, 0, 0, 0, 0], "start": [0, -1.5708, 0, 0, 0, 0]}
            ]\
            """);
    start(cell, "left", "movej([0, 0.3, -0.3, -1.5708, 1.5708, 0])");
    for (int i = 0; i < 3000 && state(cell, "left").safety().stop().isEmpty(); i++) {
      cell.advance();
    }
    cell.advance();
    String said = state(cell, "right").safety().stop().orElseThrow().message();
    assertTrue(said.contains("the base has hit the "), said);
  }

  private static double nearestM(Cell cell, String name) {
    return state(cell, name).geometry().linkDistances().nearestM();
  }

  @Test
  void theNearestDistanceIsThatToAnotherArmAndTheSameForBoth() throws JsonException {
    String beside =
        "\"arms\": [{\"name\": \"left\"}, {\"name\": \"right\", \"base\": [0, %s, 0, 0, 0, 0]}]";
    double aloneM = nearestM(cell(beside.formatted(5)), "left");
    Cell near = cell(beside.formatted(0.3));
    double nearM = nearestM(near, "left");
    assertTrue(nearM > 0 && nearM < aloneM - 0.02, nearM + " m, alone " + aloneM);
    assertEquals(nearM + 0.01, nearestM(cell(beside.formatted(0.31)), "left"), 1e-4);
    near.advance();
    assertEquals(nearM, nearestM(near, "left"), 1e-5);
    assertEquals(nearestM(near, "left"), nearestM(near, "right"), 1e-6);
  }

  private static Cell near(ControllerOptions each) throws JsonException {
    Cell cell =
        cell(
            """
            "arms": [
              {"name": "left", "start": [0, -1.5708, -1.5708, -1.5708, 1.5708, 0]},
              {"name": "right", "base": [1, 0, 0, 0, 0, 3.141592653589793],
               "start": [1, -1.5708, -1.5708, -1.5708, 1.5708, 0]}
            ]\
            """,
            each);
    start(cell, "right", "movej([0.7, -1.5708, -1.5708, -1.5708, 1.5708, 0])");
    return cell;
  }

  @ParameterizedTest
  @EnumSource
  void anArmThatStandsStillKnowsHowNearTheOtherOneComes(ArmChoice arms) throws JsonException {
    Cell cell = near(ControllerOptions.headless().withArm(arms));
    double beforeM = nearestM(cell, "left");
    runUntilStopped(cell, "right", 3000);
    double afterM = nearestM(cell, "left");
    assertTrue(afterM < beforeM - 0.01, afterM + " m, before " + beforeM);
    assertEquals(nearestM(cell, "right"), afterM, 1e-4);
  }

  @Test
  void anArmDoesNotRestForRecordingsWhileAnotherOneMoves() throws JsonException {
    Cell cell = near(ControllerOptions.headless().withMeasuredNoise(true));
    int rested = 0;
    for (int i = 0; i < 2500; i++) {
      cell.advance();
      ControllerState other = state(cell, "right");
      rested += state(cell, "left").armRests() && !other.armRests() && other.arm().moving() ? 1 : 0;
    }
    assertEquals(0, rested);
    assertTrue(state(cell, "left").armRests());
  }

  @ParameterizedTest
  @EnumSource
  void anArmPushesWhatTheOtherOneSees(ArmChoice arms) throws JsonException {
    Cell cell =
        cell(
            FACING
                + """
                , "objects": [
                  {"type": "plane", "name": "floor", "point": [0, 0, 0.2], "normal": [0, 0, 1]},
                  {"type": "box", "name": "part", "pose": [0.48, 0.1, 0.25, 0, 0, 0],
                   "size": [0.1, 0.1, 0.1], "mass": 0.5}
                ], "tool": [{"point": [0, 0, 0.1]}]\
                """,
            ControllerOptions.headless().withArm(arms));
    start(
        cell,
        "left",
        "movel(p[0.49, -0.1, 0.37, 2.22, 2.22, 0])",
        "movel(p[0.49, 0.2, 0.37, 2.22, 2.22, 0])");
    runUntilStopped(cell, "left", 20_000);
    Pose seenByLeft = bodyOf(cell, "left");
    Pose seenByRight = bodyOf(cell, "right");
    assertTrue(seenByLeft.y() > 0.15, () -> "the part is at " + seenByLeft);
    assertEquals(1.2 - seenByLeft.x(), seenByRight.x(), 1e-9);
    assertEquals(-seenByLeft.y(), seenByRight.y(), 1e-9);
    assertEquals(seenByLeft.z(), seenByRight.z(), 1e-9);
  }

  @Test
  void anArmDoesTheSameWhereverItStands() throws JsonException {
    String push =
        """
        , "tool": [{"point": [0, 0, 0.1]}], "objects": [
          {"type": "plane", "name": "floor", "point": [0, 0, 0.2], "normal": [0, 0, 1]},
          {"type": "box", "name": "part", "pose": [%s, 0.25, 0, 0, %s],
           "size": [0.1, 0.1, 0.1], "mass": 0.5}
        ]\
        """;
    Cell one = cell(FACING + push.formatted("0.48, 0.1", "0"));
    Cell other = cell(FACING + push.formatted("0.72, -0.1", "3.141592653589793"));
    String[] moves = {
      "movel(p[0.49, -0.1, 0.37, 2.22, 2.22, 0])", "movel(p[0.49, 0.2, 0.37, 2.22, 2.22, 0])"
    };
    start(one, "left", moves);
    start(other, "right", moves);
    runUntilStopped(one, "left", 20_000);
    runUntilStopped(other, "right", 20_000);
    Pose byLeft = bodyOf(one, "left");
    Pose byRight = bodyOf(other, "right");
    assertTrue(byLeft.y() > 0.15);
    assertEquals(byLeft.x(), byRight.x(), 1e-4);
    assertEquals(byLeft.y(), byRight.y(), 1e-4);
    assertEquals(state(one, "left").timeS(), state(other, "right").timeS(), 0.01);
  }

  @Test
  void aSensorSeesTheToolOfEachArm() throws JsonException {
    String sensor =
        ", \"devices\": [{\"type\": \"proximity\", \"signal\": \"left.digital_in[0]\","
            + " \"at\": [%s], \"range\": 0.05}]";
    Pose tcp = state(cell(FACING), "right").arm().actualTcpInBase();
    String atRight = (1.2 - tcp.x()) + ", " + -tcp.y() + ", " + tcp.z();
    Cell cell = cell(FACING + sensor.formatted(atRight));
    cell.advance();
    assertTrue(state(cell, "left").io().level(Signal.named("digital_in[0]")));
  }

  @Test
  void anArmOnAWallHoldsItself() throws JsonException {
    Cell cell =
        cell(
            """
            "arms": [
              {"name": "left"},
              {"name": "wall", "base": [2, 0, 1, 0, -1.5707963267948966, 0]}
            ]\
            """);
    start(cell, "wall", "global felt = get_gravity()", "sleep(0.5)");
    runUntilStopped(cell, "wall", 1000);
    assertEquals(
        "[9.82, 0, 0]",
        controller(cell, "wall").globals().get("felt").text().replaceAll("e-1\\d", ""));
    assertTrue(state(cell, "wall").safety().stop().isEmpty());
  }

  @Test
  void aCellComesToTheSameBitsInEachRun() throws JsonException {
    assertEquals(run(), run());
  }

  private static String run() throws JsonException {
    Cell cell =
        cell(
            FACING
                + """
                , "tool": [{"point": [0, 0, 0.1]}], "objects": [
                  {"type": "plane", "name": "floor", "point": [0, 0, 0.2], "normal": [0, 0, 1]},
                  {"type": "box", "name": "part", "pose": [0.6, 0.1, 0.25, 0, 0, 0],
                   "size": [0.2, 0.1, 0.1], "mass": 0.5}
                ]\
                """);
    String[] moves = {
      "movel(p[0.49, -0.1, 0.37, 2.22, 2.22, 0])", "movel(p[0.49, 0.1, 0.37, 2.22, 2.22, 0])"
    };
    start(cell, "left", moves);
    start(cell, "right", moves);
    runUntilStopped(cell, "left", 20_000);
    return state(cell, "left").moved()
        + " "
        + state(cell, "left").arm().actualPositionRad()
        + state(cell, "right").arm().actualPositionRad();
  }

  @Test
  void robotTimeThatIsBehindIsToldOnce() throws JsonException {
    Cell cell = cell(FACING + ", \"script\": \"plc.script\"");
    cell.noteLostTime(0.25);
    cell.advance();
    cell.noteLostTime(2);
    cell.advance();
    for (String name : List.of("left", "right", "cell")) {
      long lines =
          controller(cell, name).logSince(0).stream()
              .filter(each -> each.text().startsWith("robot time is "))
              .count();
      assertEquals(name.equals("left") ? 2 : 0, lines, name);
      assertEquals(2, state(cell, name).behindS(), name);
    }
  }

  @Test
  void idealArmsPassThroughOneAnother() throws JsonException {
    Cell cell =
        cell(
            "\"arms\": [{\"name\": \"left\"}, {\"name\": \"right\", \"base\": [0.1, 0, 0, 0, 0,"
                + " 0]}]",
            ControllerOptions.headless().withArm(ArmChoice.IDEAL));
    start(cell, "left", "movej([1, -1, -1, -1, 1, 0])");
    runUntilStopped(cell, "left", 5000);
    assertTrue(state(cell, "left").safety().stop().isEmpty());
  }

  @Test
  void whatAnArmCannotDoIsToldAtItsPlace() {
    JsonException far =
        assertThrows(
            JsonException.class,
            () ->
                cell(
                    """
                    "arms": [
                      {"name": "left"},
                      {"name": "right", "base": [-9, 0, 0, 0, 0, 0]}
                    ],
                    "objects": [{"type": "sphere", "name": "ball", "centre": [5, 0, 0],
                                 "radius": 0.1}]\
                    """));
    assertTrue(
        far.getMessage()
            .startsWith("cell.json:3:3: right: object \"ball\" is too far from this base"),
        far.getMessage());
  }
}
