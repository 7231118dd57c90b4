package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.arm.ArmLibrary;

final class RobotsCommandTest {

  private static List<String> robots(String... words) throws UsageException {
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    Console console = new Console(output, new ByteArrayOutputStream());
    RobotsCommand command = new RobotsCommand();

    ExitCode code = command.run(Arguments.parse(command.options(), List.of(words)), console);

    console.flush();
    assertEquals(ExitCode.DONE, code);
    return output.toString(StandardCharsets.UTF_8).lines().toList();
  }

  private static String refusal(String... words) {
    return assertThrows(UsageException.class, () -> robots(words)).getMessage();
  }

  @Test
  void listHasALineForEachArm() throws UsageException {
    List<String> lines = robots();

    assertEquals(
        ArmLibrary.ids(), lines.stream().skip(1).map(line -> line.split(" ", 2)[0]).toList());
    assertEquals(
        "id       name      series     payload    reach  joint speeds, deg/s      "
            + "derived, assumed or estimated",
        lines.getFirst());
    assertTrue(
        lines.contains(
            "ur7e     UR7e      e-Series    7.5 kg   850 mm  180 180 180 180 180 180  "
                + "limits, drives, shape"),
        () -> String.join("\n", lines));
  }

  @Test
  void sheetHasTheNumbersOfOneArmAndWhatTheyAreWorth() throws UsageException {
    String sheet = String.join("\n", robots("ur8long"));

    for (String part :
        List.of(
            "UR8 Long (ur8long), UR-Series\npayload 10 kg, reach 1750 mm\n",
            """
            Lengths (Denavit-Hartenberg), m: verified
                  d1       a2       a3      d4      d5      d6
              0.2186  -0.8989  -0.7149  0.1824  0.1361  0.1434
            """,
            "Limits of the joints: assumed\n",
            "  elbow          -360      360           240         204\n",
            "Drives, seen from the joint\n",
            "  elbow              2.9  10.5        1.01      0.486         0.48             0.583  "
                + "         0\n",
            "  elbow     estimated      estimated        estimated\n",
            "Links: verified\n",
            "  upper arm   17.0738             0.565429  -0.000074    0.19542\n",
            "  together    39.9439\n",
            "  lengths           verified   two independent public sources agree\n",
            "  limits            assumed    taken over from a sister model\n",
            "Notes\n  - joint limits of the UR15, which has the same joints\n")) {
      assertTrue(sheet.contains(part), () -> "no " + part + " in\n" + sheet);
    }
  }

  @Test
  void jointWithoutEndHasNoRange() throws UsageException {
    List<String> lines = robots("ur3e");
    assertTrue(
        lines.contains("  wrist 3      no end   no end           360           9"),
        () -> String.join("\n", lines));
  }

  @Test
  void longNotesAreBrokenIntoLines() throws UsageException {
    List<String> lines = robots("ur30");
    assertTrue(
        lines.get(lines.indexOf("Notes") + 2).startsWith("    "), () -> String.join("\n", lines));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ur3", "ur5", "ur10", "ur3e", "ur5e", "ur7e", "ur10e", "ur12e", "ur16e", "ur8long", "ur15",
        "ur18", "ur20", "ur30"
      })
  void everySheetFitsATerminal(String id) throws UsageException {
    for (String line : robots(id)) {
      assertTrue(line.length() <= 100, line);
    }
  }

  @Test
  void displayNameNeedsNoQuotes() throws UsageException {
    assertEquals(robots("ur8long"), robots("UR8", "Long"));
  }

  @Test
  void pageNamesEveryArm() throws UsageException {
    List<String> page = robots("--markdown");

    assertEquals("# Robots", page.getFirst());
    for (String id : ArmLibrary.ids()) {
      assertEquals(1, page.stream().filter(line -> line.startsWith("| `" + id + "` |")).count());
    }
    assertTrue(
        page.contains(
            "| UR30 | verified | verified | estimated | verified | estimated | estimated |"
                + " estimated | measured |"));
    assertTrue(
        page.contains(
            "| UR10e | 0 | 330 | 6.03 | 11.976 | 1.429 | 0.695 | 0.465 | 0.819 | 0 |"
                + " measured, measured, measured |"));
  }

  @Test
  void mistakesAreNamed() {
    assertEquals(
        "the name is ur6e, must be one of "
            + String.join(", ", ArmLibrary.ids())
            + "; did you mean ur3e?",
        refusal("ur6e"));
    assertEquals("unexpected ur5e, the page has all arms", refusal("--markdown", "ur5e"));
    assertEquals("unknown option --markdwn, did you mean --markdown?", refusal("--markdwn"));
  }
}
