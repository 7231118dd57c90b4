package org.pendant.command;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code pendant check --cell} of a scene in which several controllers work. */
final class SharedCellCheckTest {
  private static final String IN = "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])";
  private static final String OUT = "movej([1.5, -1.5708, -1.5708, -1.5708, 1.5708, 0])";

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  /** Two arms that face one another, and turn in and out. */
  @BeforeEach
  void writeCell() throws IOException {
    write("cell.json", cell("\"program\": \"right.script\", "));
    write("left.script", program("left", "sleep(0.5)", IN, OUT));
    write("right.script", program("right", IN, "sleep(0.5)", OUT));
  }

  private static String cell(String right) {
    return cell(right, 1.2);
  }

  private static String cell(String right, double rightBaseRad) {
    String start = "\"start\": [%s, -1.5708, -1.5708, -1.5708, 1.5708, 0]";
    return "{\"arms\": [{\"name\": \"left\", \"program\": \"left.script\", "
        + start.formatted(1.2)
        + "}, {\"name\": \"right\", \"base\": [1, 0, 0, 0, 0, 3.141592653589793], "
        + right
        + start.formatted(rightBaseRad)
        + "}]}";
  }

  private static String program(String name, String... lines) {
    return "def " + name + "():\n  " + String.join("\n  ", lines) + "\nend\n";
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private ExitCode check(String... words) {
    List<String> all = new ArrayList<>(List.of("check"));
    for (String word : words) {
      all.add(word.contains(".") ? folder.resolve(word).toString() : word);
    }
    output.reset();
    errors.reset();
    return new Pendant(new Console(output, errors)).run(all);
  }

  private List<String> told() {
    return errors.toString(UTF_8).replace(folder + "/", "").lines().toList();
  }

  @Test
  void theProgramsRunTogetherAndEachIsToldWithItsLineAndThatOfTheOther() {
    assertEquals(ExitCode.DOES_NOT_COMPILE, check("--cell", "cell.json"));
    String left =
        "left.script:3: error: the wrist 2 has hit the wrist 2 of right \\(right.script:\\d\\) at"
            + " \\d\\.\\d{3} s, \\d+\\.\\d mm deep, until \\d\\.\\d{3} s";
    assertTrue(told().getFirst().matches(left), told()::toString);
    List<String> right = told().stream().filter(each -> each.startsWith("right.script:")).toList();
    assertTrue(
        right
            .getFirst()
            .matches(
                "right.script:\\d: error: the wrist 2 has hit the wrist 2 of left"
                    + " \\(left.script:3\\) at .*"),
        told()::toString);
    assertEquals("", output.toString(UTF_8));
  }

  @Test
  void anArmThatRunsNothingIsHit() throws IOException {
    write("cell.json", cell(""));
    write("left.script", program("left", "movej([0.3, -1.5708, -1.5708, -1.5708, 1.5708, 0])"));
    assertEquals(ExitCode.DONE, check("--cell", "cell.json"), told()::toString);
    assertTrue(told().getFirst().contains("nothing is hit; nearest is"), told()::toString);
    write("cell.json", cell("", 0));
    write("left.script", program("left", IN));
    assertEquals(ExitCode.DOES_NOT_COMPILE, check("--cell", "cell.json"));
    assertTrue(
        told()
            .getFirst()
            .matches("left.script:2: error: the [a-z0-9 ]+ has hit the .* of right at .*"),
        told()::toString);
  }

  @Test
  void armsThatWaitForOneAnotherKeepClear() throws IOException {
    write("left.script", program("left", IN, OUT, "set_standard_digital_out(0, True)"));
    write(
        "right.script",
        program("right", "while not get_standard_digital_in(0):", "  sync()", "end", IN, OUT));
    String wire = ", \"wires\": [[\"left.digital_out[0]\", \"right.digital_in[0]\"]]}";
    String cell = cell("\"program\": \"right.script\", ");
    write("cell.json", cell.substring(0, cell.length() - 1) + wire);
    assertEquals(ExitCode.DONE, check("--cell", "cell.json"), told()::toString);
    assertEquals(2, told().size(), told()::toString);
    assertTrue(told().getFirst().startsWith("left.script: note: nothing is hit"), told()::toString);
    assertTrue(told().getLast().startsWith("right.script: note: nothing is hit"), told()::toString);
  }

  @Test
  void meshesOnTheFlangesOfBothArmsAreAmongWhatIsHit() throws IOException {
    write(
        "bar.obj",
        """
        v -40 -40 0
        v 40 -40 0
        v 40 40 0
        v -40 40 0
        v -40 -40 300
        v 40 -40 300
        v 40 40 300
        v -40 40 300
        f 4 3 2 1
        f 5 6 7 8
        f 1 2 6 5
        f 2 3 7 6
        f 3 4 8 7
        f 4 1 5 8
        """);
    String tool =
        "\"tool\": [{\"type\": \"mesh\", \"name\": \"bar\", \"pose\": [0, 0, 0, 0, 0, 0],"
            + " \"mesh\": \"bar.obj\", \"unit\": \"mm\"}], ";
    write(
        "cell.json",
        cell(tool + "\"program\": \"right.script\", ")
            .replace("\"name\": \"left\", ", "\"name\": \"left\", " + tool));
    assertEquals(ExitCode.DOES_NOT_COMPILE, check("--cell", "cell.json"));
    for (String arm : List.of("left", "right")) {
      String other = arm.equals("left") ? "right" : "left";
      assertTrue(
          told().stream()
              .anyMatch(
                  each ->
                      each.startsWith(arm + ".script:")
                          && each.contains("the tool has hit the tool of " + other)),
          told()::toString);
    }
  }

  @Test
  void eachRunWritesTheSameJson() throws IOException {
    check("--cell", "cell.json", "--json", "found.json");
    String first = Files.readString(folder.resolve("found.json"));
    check("--cell", "cell.json", "--json", "found.json", "--force");
    assertEquals(first, Files.readString(folder.resolve("found.json")));
    assertTrue(first.contains("\"controller\": \"left\",\n"), first);
    assertTrue(
        first.contains("\"other_link\": \"wrist 2\", \"arm\": \"left\", \"depth\": 0.0"), first);
    assertTrue(first.contains(", \"arm_line\": 3, \"time\": "), first);
  }

  @Test
  void programsThatGoOnAreLookedAtForAWhile() throws IOException {
    write("left.script", program("left", "while True:", "  sync()", "end"));
    assertEquals(ExitCode.DONE, check("--cell", "cell.json", "--timeout", "3"), told()::toString);
    assertEquals(
        "left.script: note: looked at its first 3.0 s; --timeout says how many", told().getLast());
  }

  @Test
  void anotherProgramIsRefused() throws IOException {
    write("more.script", program("more", IN));
    assertEquals(ExitCode.WRONG_USAGE, check("--cell", "cell.json", "more.script"));
    assertTrue(
        told().getFirst().contains("cell.json has arms with programs of their own"),
        told()::toString);
  }

  @Test
  void aProgramOfTheSceneIsNeverOverwritten() {
    assertEquals(
        ExitCode.WRONG_USAGE, check("--cell", "cell.json", "--json", "left.script", "--force"));
    assertTrue(told().getFirst().contains("never overwrites"), told()::toString);
  }
}
