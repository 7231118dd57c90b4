package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/** The arm, what it touches and what stops it, through {@code pendant run}. */
@Tag("slow")
final class ArmAndSafetyTest {
  @TempDir Path folder;

  private void script(String name, String... lines) {
    Launcher.script(folder, name, String.join("\n", lines) + "\n");
  }

  private void file(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private static final String TABLE =
      """
      {"objects": [{"type": "plane", "name": "table", "point": [0, 0, 0.3], "normal": [0, 0, 1]}]}
      """;

  @Test
  void theArmFollowsItsTargetCloselyUnlessItIsIdealAndExact() {
    script(
        "move.script",
        "def move():",
        "  movej([0.5, -1.2, -1.6, -1.57, 1.57, 0])",
        "  a = get_actual_joint_positions()",
        "  t = get_target_joint_positions()",
        "  textmsg(norm(a - t) < 0.0001)",
        "  textmsg(norm(a - t) == 0)",
        "end");

    assertEquals("True\nFalse\n", Launcher.pendant(folder, "run", "move.script").output());
    assertEquals(
        "True\nTrue\n", Launcher.pendant(folder, "run", "--arm", "ideal", "move.script").output());
  }

  @Test
  void everyArmRunsTheSameProgram() {
    script(
        "hello.script",
        "def hello():",
        "  q = get_target_joint_positions()",
        "  q[0] = 0.5",
        "  movej(q)",
        "  textmsg(\"joints: \", length(get_joint_torques()))",
        "end");
    for (String robot : List.of("ur3e", "UR8 Long", "ur16e", "UR30")) {
      Result result = Launcher.pendant(folder, "run", "--robot", robot, "hello.script");
      assertEquals("joints: 6\n", result.output(), robot + result.errors());
    }
  }

  @Test
  void aTableInTheWayStopsTheProgramWithCodeJointTimeAndLimit() throws IOException {
    file("table.json", TABLE);
    script(
        "press.script",
        "def press():",
        "  p = get_actual_tcp_pose()",
        "  textmsg(\"down\")",
        "  movel(pose_add(p, p[0, 0, -0.3, 0, 0, 0]), a=0.5, v=0.1)",
        "  textmsg(\"never\")",
        "end");

    Result result = Launcher.pendant(folder, "run", "--scene", "table.json", "press.script");

    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("down\n", result.output()),
        () -> assertTrue(result.errors().contains("stopped in line 4: C15"), result.errors()),
        () -> assertTrue(result.errors().contains("protective stop at "), result.errors()),
        () -> assertTrue(result.errors().contains("limit"), result.errors()));
  }

  @Test
  void anUndeclaredLoadWeighsOnTheForceSensor() throws IOException {
    file("load.json", "{\"load\": {\"mass\": 2, \"cog\": [0, 0, 0.05]}}");
    script(
        "weigh.script",
        "def weigh():",
        "  sleep(0.5)",
        "  weight = -get_tcp_force()[2]",
        "  textmsg(weight > 19.44 and weight < 19.84)",
        "  set_target_payload(2, [0, 0, 0.05])",
        "  sleep(0.5)",
        "  textmsg(force() < 0.1)",
        "end");

    Result result = Launcher.pendant(folder, "run", "--scene", "load.json", "weigh.script");

    assertEquals("True\nTrue\n", result.output(), result.errors());
  }

  @Test
  void aSafetyInputKeepsTheProgramFromRunning() {
    script("hello.script", "def hello():", "  sleep(1)", "  textmsg(\"hello\")", "end");

    Result result =
        Launcher.pendant(folder, "run", "--input", "safeguard_stop=true", "hello.script");

    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("", result.output()),
        () -> assertTrue(result.errors().contains("safeguard stop"), result.errors()));
  }

  @Test
  void aSafetyPlaneStopsTheArmBeforeItIsReached() throws IOException {
    file(
        "safety.json",
        """
        {"planes": [{"name": "wall", "pointM": [0, 0, 0.4], "allowedSide": [0, 0, 1]}]}
        """);
    script(
        "down.script",
        "def down():",
        "  textmsg(is_within_safety_limits(get_actual_tcp_pose()))",
        "  below = pose_add(get_actual_tcp_pose(), p[0, 0, -0.2, 0, 0, 0])",
        "  textmsg(is_within_safety_limits(below))",
        "  movel(below)",
        "end");

    Result result = Launcher.pendant(folder, "run", "--safety", "safety.json", "down.script");

    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("True\nFalse\n", result.output(), result.errors()),
        () -> assertTrue(result.errors().contains("C152"), result.errors()),
        () -> assertTrue(result.errors().contains("wall"), result.errors()));
  }

  @Test
  void aProtectiveStopOfTheProgramItselfEndsARunThatNobodyWatches() {
    script("stop.script", "def stop():", "  protective_stop()", "  textmsg(\"never\")", "end");

    Result result = Launcher.pendant(folder, "run", "stop.script");

    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("", result.output()),
        () -> assertTrue(result.errors().contains("protective stop"), result.errors()));
  }

  @Test
  void aProtectiveStopThatIsTheLastThingAProgramDoesIsAnErrorToo() {
    script("stop.script", "def stop():", "  textmsg(\"before\")", "  protective_stop()", "end");

    Result result = Launcher.pendant(folder, "run", "stop.script");

    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("before\n", result.output()),
        () ->
            assertTrue(
                result.errors().contains("stopped in line 3: C209A0 protective stop"),
                result.errors()));
  }

  @Test
  void powerdownEndsTheProgramWithoutAnError() {
    script(
        "off.script",
        "def off():",
        "  textmsg(\"bye\")",
        "  powerdown()",
        "  textmsg(\"never\")",
        "end");

    Result result = Launcher.pendant(folder, "run", "off.script");

    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals("bye\n", result.output()));
  }

  @Test
  void mistakesInFilesAndOptionsAreShownWithTheirPlace() throws IOException {
    script("hello.script", "def hello():", "  textmsg(\"hello\")", "end");
    file("bad.json", "{\"objects\": [\n  {\"type\": \"cone\", \"name\": \"x\"}]}");
    file("worse.json", "{\"planes\": 7}");

    Result scene = Launcher.pendant(folder, "run", "--scene", "bad.json", "hello.script");
    Result safety = Launcher.pendant(folder, "run", "--safety", "worse.json", "hello.script");
    Result missing = Launcher.pendant(folder, "run", "--scene", "nosuch.json", "hello.script");
    Result arm = Launcher.pendant(folder, "run", "--arm", "soft", "hello.script");
    Result noise = Launcher.pendant(folder, "run", "--encoder-noise", "1", "hello.script");

    assertAll(
        () -> assertEquals(2, scene.exitCode()),
        () -> assertTrue(scene.errors().contains("bad.json:2:12: type is"), scene.errors()),
        () -> assertEquals(2, safety.exitCode()),
        () -> assertTrue(safety.errors().contains("worse.json:1:"), safety.errors()),
        () -> assertEquals(2, missing.exitCode()),
        () ->
            assertTrue(
                missing.errors().contains("nosuch.json: there is no such file"), missing.errors()),
        () -> assertEquals(2, arm.exitCode()),
        () -> assertTrue(arm.errors().contains("must be dynamic or ideal"), arm.errors()),
        () -> assertEquals(2, noise.exitCode()),
        () -> assertTrue(noise.errors().contains("0 to 0.01 rad"), noise.errors()));
  }

  @Test
  void noiseOfTheEncodersRepeatsWithItsSeed() {
    script(
        "noise.script",
        "def noise():",
        "  sleep(0.1)",
        "  textmsg(get_actual_joint_positions()[0])",
        "end");
    String first =
        Launcher.pendant(folder, "run", "--encoder-noise", "0.001", "noise.script").output();
    assertTrue(!first.equals("0\n"), first);
    assertEquals(
        first,
        Launcher.pendant(folder, "run", "--encoder-noise", "0.001", "noise.script").output());
    Result other =
        Launcher.pendant(folder, "run", "--encoder-noise", "0.001", "--seed", "5", "noise.script");
    assertTrue(!first.equals(other.output()), other.output());
  }
}
