package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.command.Launcher.Result;

/** {@code pendant robots}, and choosing an arm for a run. */
@Tag("slow")
final class RobotsTest {
  @TempDir Path folder;

  @Test
  void listHasAHeadingAndALineForEachOfTheFourteenArms() {
    Result result = Launcher.pendant(folder, "robots");

    assertAll(
        () -> assertEquals(0, result.exitCode()),
        () -> assertEquals("", result.errors()),
        () -> assertEquals(15, result.outputLines().size(), result.output()),
        () -> assertTrue(result.output().contains("\nur8long  UR8 Long "), result.output()),
        () -> assertTrue(result.output().contains(" 12.5 kg "), result.output()));
  }

  @Test
  void oneArmIsDescribedInFull() {
    Result result = Launcher.pendant(folder, "robots", "ur5e");

    assertAll(
        () -> assertEquals(0, result.exitCode()),
        () -> assertEquals("", result.errors()),
        () -> assertTrue(result.output().startsWith("UR5e (ur5e), e-Series\n"), result.output()),
        () -> assertTrue(result.output().contains("payload 5 kg, reach 850 mm"), result.output()),
        () -> assertTrue(result.output().contains("-0.3922"), result.output()),
        () ->
            assertTrue(result.output().contains("  rotors            derived "), result.output()));
  }

  @Test
  void unknownArmIsAnsweredWithAllThatThereAre() {
    Result result = Launcher.pendant(folder, "robots", "nosuch");

    assertAll(
        () -> assertEquals(2, result.exitCode()),
        () -> assertEquals("", result.output()),
        () -> assertTrue(result.errors().contains("nosuch"), result.errors()),
        () -> assertTrue(result.errors().contains("ur3, ur5, ur10, ur3e"), result.errors()));
  }

  @Test
  void nearlyRightNameIsAnsweredWithTheRightOne() {
    Result robots = Launcher.pendant(folder, "robots", "ur16");
    Result run = Launcher.pendant(folder, "run", "--robot", "ur16", "any.script");

    assertAll(
        () -> assertEquals(2, robots.exitCode()),
        () -> assertTrue(robots.errors().contains("did you mean ur16e?"), robots.errors()),
        () -> assertEquals(2, run.exitCode()),
        () -> assertTrue(run.errors().contains("did you mean ur16e?"), run.errors()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "ur10e; p[-1.18425, -0.2907, 0.06085, 1.570796, 0, 0]",
        "UR10e; p[-1.18425, -0.2907, 0.06085, 1.570796, 0, 0]",
        "UR8 Long; p[-1.6138, -0.3258, 0.0825, 1.570796, 0, 0]"
      })
  void programRunsOnTheArmThatIsNamed(String name, String stretchedOut) {
    Launcher.script(folder, "reach.script", "textmsg(get_forward_kin([0, 0, 0, 0, 0, 0]))\n");

    Result result = Launcher.pendant(folder, "run", "--robot", name, "reach.script");

    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals(stretchedOut + "\n", result.output()));
  }

  @Test
  void robotPageIsWhatTheLibrarySays() throws IOException {
    Result result = Launcher.pendant(Launcher.home(), "robots", "--markdown");

    Path page = Launcher.home().resolve("docs/robots.md");
    assertEquals(
        new String(Files.readAllBytes(page), StandardCharsets.ISO_8859_1),
        result.output(),
        "renew it with ./pendant robots --markdown > docs/robots.md");
  }
}
