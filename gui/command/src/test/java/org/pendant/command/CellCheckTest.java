package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class CellCheckTest {
  private static final String TURN =
      """
      def turn():
        set_tcp(p[0, 0, 0.1, 0, 0, 0])
        textmsg("turning")
        movej([1.5708, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=3, v=2)
        sleep(0.1)
        movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=3, v=2)
      end
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @BeforeEach
  void writeScenes() throws IOException {
    Files.writeString(folder.resolve("post.json"), scene(0.22, 0.2));
    Files.writeString(folder.resolve("far.json"), scene(-0.3, 0.6));
  }

  /** A post beside the forearm, which turns from x to y. */
  private static String scene(double x, double y) {
    return "{\"objects\": [{\"type\": \"box\", \"name\": \"post\", \"pose\": ["
        + x
        + ", "
        + y
        + ", 0.6, 0, 0, 0], \"size\": [0.05, 0.05, 1]}]}";
  }

  private int check(String text, String... options) throws IOException {
    Path file = Files.writeString(folder.resolve("turn.script"), text);
    List<String> words = new ArrayList<>(List.of("check", file.toString()));
    for (String option : options) {
      words.add(option.endsWith(".json") ? folder.resolve(option).toString() : option);
    }
    return new Pendant(new Console(output, errors)).run(words).number();
  }

  private List<String> complaints() {
    return errors.toString(StandardCharsets.UTF_8).replace(folder + "/", "").lines().toList();
  }

  @Test
  void eachCollisionIsToldWithItsLineAndTheProgramGoesOn() throws IOException {
    assertEquals(3, check(TURN, "--cell", "post.json"));
    List<String> told = complaints();
    assertTrue(
        told.getFirst()
            .matches(
                "turn.script:4: error: the forearm has hit \"post\" at 0\\.\\d{3} s, \\d+\\.\\d mm"
                    + " deep, until 0\\.\\d{3} s"),
        told::toString);
    assertTrue(told.getLast().startsWith("turn.script:6: error: the "), told::toString);
    assertEquals("", output.toString(StandardCharsets.UTF_8));
  }

  @Test
  void whatStaysClearSaysHowNearItCame() throws IOException {
    assertEquals(0, check(TURN, "--cell", "far.json"));
    assertEquals(1, complaints().size(), () -> complaints().toString());
    assertTrue(
        complaints()
            .getFirst()
            .matches(
                "turn.script: note: nothing is hit; nearest is the [a-z0-9 ]+ to .*,"
                    + " \\d+\\.\\d mm at \\d\\.\\d{3} s in line \\d"),
        () -> complaints().toString());
  }

  @Test
  void allOfItIsWrittenAsJson() throws IOException {
    assertEquals(3, check(TURN, "--cell", "post.json", "--json", "found.json"));
    String json = Files.readString(folder.resolve("found.json"));
    assertTrue(json.contains("{\"link\": \"forearm\", \"object\": \"post\", \"depth\": 0.0"), json);
    assertTrue(json.contains("\"line\": 4, \"time\": 0."), json);
    assertTrue(json.contains("\"nearest\": {"), json);
  }

  @Test
  void anEndlessProgramIsLookedAtForAWhile() throws IOException {
    String endless = "def wait():\n  while True:\n    sleep(1)\n  end\nend\n";
    assertEquals(0, check(endless, "--cell", "far.json", "--timeout", "2"));
    assertEquals(
        "turn.script: note: looked at its first 2.0 s; --timeout says how many",
        complaints().getLast());
  }

  @Test
  void aProgramThatFailsIsToldAsARunTellsIt() throws IOException {
    assertEquals(1, check("def p():\n  a = [1]\n  b = a[3]\nend\n", "--cell", "far.json"));
    assertTrue(complaints().getFirst().startsWith("turn.script:3:"), complaints()::toString);
  }

  @Test
  void optionsOfTheRunAreRefusedWithoutAScene() throws IOException {
    assertEquals(2, check(TURN, "--robot", "ur10e"));
    assertTrue(
        complaints().getFirst().contains("--robot goes with --cell, which is missing"),
        complaints()::toString);
  }
}
