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

/** What {@code pendant test --mutate} tells, and how it ends. */
final class TestMutationTest {
  @TempDir private Path folder;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @BeforeEach
  void files() throws IOException {
    Files.writeString(
        folder.resolve("half.script"), "def half(a):\n  sleep(0.1)\n  return a / 2\nend\n");
    test("assert_near(half(4), 2)");
  }

  private void test(String statement) throws IOException {
    Files.writeString(
        folder.resolve("half_test.script"),
        "import_script(\"half.script\")\ndef test_half():\n  " + statement + "\nend\n");
  }

  private int run(String... more) {
    List<String> arguments = new ArrayList<>(List.of("test", folder.toString()));
    arguments.addAll(List.of(more));
    return new Pendant(new Console(out, errors)).run(arguments).number();
  }

  private String output() {
    return out.toString(StandardCharsets.UTF_8);
  }

  private String errors() {
    return errors.toString(StandardCharsets.UTF_8);
  }

  @Test
  void survivorsAreToldAndAreNoFailureByThemselves() {
    assertEquals(0, run("--mutate"));

    assertTrue(output().contains("4 mutants\n"), output());
    assertTrue(output().contains("half.script:2:3: call dropped\n  - sleep(0.1)\n"), output());
  }

  @Test
  void aScoreThatIsNotReachedIsAFailure() {
    assertEquals(1, run("--mutate", "--mutation-score", "50.5"));

    assertTrue(errors().contains("the mutation score is 50.0 %, wanted are 50.5 %"), errors());
  }

  @Test
  void nothingIsMutatedWhereTestsAreRed() throws IOException {
    test("assert_near(half(4), 3)");

    assertEquals(1, run("--mutate"));

    assertTrue(errors().contains("nothing is mutated: all tests have to run"), errors());
  }

  @Test
  void eachOptionOfMutationAsksForIt() {
    assertEquals(0, run("--mutants", "2"));

    assertTrue(output().contains("2 mutants of 4, chosen by the seed\n"), output());
  }

  @Test
  void theFileForViewersReplacesAnEarlierOne() throws IOException {
    Path file = folder.resolve("mutation.json");

    assertEquals(0, run("--mutate", "--mutation-json", file.toString()), errors());
    assertEquals(0, run("--mutate", "--mutation-json", file.toString()), errors());

    assertTrue(Files.readString(file).contains("\"status\": \"Survived\""));
  }
}
