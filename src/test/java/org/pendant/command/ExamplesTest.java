package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.command.Launcher.Result;

/** The programs in examples/ and the documentation that is generated. */
@Tag("slow")
final class ExamplesTest {
  /** These wait for one another in one cell; tests beside them run them there. */
  private static final Predicate<String> IN_A_CELL =
      Pattern.compile("/handover_[a-z]+\\.script$").asPredicate();

  private static String[] command(String subcommand) throws IOException {
    List<String> words = new ArrayList<>(List.of(subcommand));
    try (Stream<Path> files = Files.list(Launcher.home().resolve("examples"))) {
      files
          .map(Path::toString)
          .filter(name -> name.endsWith(".script") || name.endsWith(".pendant"))
          .sorted()
          .forEach(words::add);
    }
    return words.toArray(new String[0]);
  }

  @Test
  void examplesHaveNothingToComplainAbout() throws IOException {
    Result result = Launcher.pendant(Launcher.home(), command("check"));

    assertAll(() -> assertEquals(0, result.exitCode()), () -> assertEquals("", result.errors()));
  }

  @Test
  void examplesRunAndDoWhatTheySay() throws IOException {
    String[] command =
        Stream.of(command("run")).filter(word -> !IN_A_CELL.test(word)).toArray(String[]::new);
    assertTrue(command.length > 8, "too few examples");

    Result result = Launcher.pendant(Launcher.home(), command);

    assertEquals(0, result.exitCode(), result.errors());
    assertTrue(
        result
            .outputLines()
            .containsAll(
                List.of(
                    "Hello from Pendant",
                    "orders done: 8",
                    "the queue was full: True",
                    "inverse kinematics leads back home",
                    "there is another posture for the same place",
                    "went to p[0.5, -0.2, 0.2, 2.2214, -2.2214, 0]",
                    "boxes stacked: 12",
                    "bracket at p[0.4125, -0.08, 0, 0, 0, 1.570796]",
                    "parts understood: 2",
                    "done, parts placed: 4",
                    "tray is full, boxes: 6",
                    "portions done: 20",
                    "and the threads did have to wait for each other",
                    "no belt here; give this a cell with --scene",
                    "no box at the feeder; give this a cell with --scene",
                    "no gripper here",
                    "no peg here; give this a cell with --scene",
                    "no belt to sort from; give this a cell with --scene",
                    "no blank for the machine; give this a cell with --scene",
                    "all corners met within a millimetre",
                    "mean: 5",
                    "spring rate in N/mm: 1.97",
                    "preload in N: 1.06",
                    "x turned: [0, 1, 0]",
                    "all nods done: 5",
                    "the watcher was awake")),
        result.output());
  }

  @Test
  void watchedInputStopsTheExampleEarly() {
    Result result =
        Launcher.pendant(
            Launcher.home(), "run", "--input", "digital_in[0]=true", "examples/watch_input.script");

    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertTrue(result.output().startsWith("button pressed\n"), result.output()));
  }

  @Test
  void theTestsOfTheExamplesPass() {
    Result result = Launcher.pendant(Launcher.home(), "test", "--color", "never", "examples");

    assertEquals(0, result.exitCode(), result.output() + result.errors());
    assertTrue(result.output().contains("72 passed in "), result.output());
  }

  @Test
  void theReferenceOfTestFunctionsIsWhatTheCatalogueSays() throws IOException {
    Result result = Launcher.pendant(Launcher.home(), "functions", "--tests", "--markdown");

    Path page = Launcher.home().resolve("docs/testing-functions.md");
    assertEquals(
        new String(Files.readAllBytes(page), StandardCharsets.ISO_8859_1),
        result.output(),
        "renew it with ./pendant functions --tests --markdown > docs/testing-functions.md");
  }

  @Test
  void functionReferenceIsWhatTheCatalogueSays() throws IOException {
    Result result = Launcher.pendant(Launcher.home(), "functions", "--markdown");

    Path page = Launcher.home().resolve("docs/functions.md");
    assertEquals(
        new String(Files.readAllBytes(page), StandardCharsets.ISO_8859_1),
        result.output(),
        "renew it with ./pendant functions --markdown > docs/functions.md");
  }
}
