package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.service.GoldenComparison;
import org.pendant.testing.TestId;

final class GoldenRecordingsTest {
  private static final String PICK =
      """
      def pick():
        set_standard_digital_out(0, True)
        movej([0.05, -1.5, 0, -1.5, 0, 0], a=2, v=1)
        sleep(0.1)
      end
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final FakeRenderer renderer = new FakeRenderer();

  private int test(String... words) {
    List<String> all = new ArrayList<>(List.of("test", "--color", "never"));
    all.addAll(List.of(words));
    output.reset();
    DesktopServices services =
        new DesktopServices(Optional::empty, () -> Optional.of(() -> renderer));
    return new Pendant(new Console(output, new ByteArrayOutputStream()), services)
        .run(all)
        .number();
  }

  private String said() {
    return output.toString(StandardCharsets.UTF_8).replace(folder + "/", "");
  }

  private void golden(String program) throws IOException {
    Files.writeString(folder.resolve("pick.script"), program);
    Files.writeString(
        folder.resolve("pick_test.script"),
        """
        # @golden
        def test_runs():
          start("pick.script")
          wait_for_end()
        end
        """);
  }

  @Test
  void aTestWithARecordingToCompareWithNeedsOneThatIsMadeOnlyWhenAskedFor() throws IOException {
    golden(PICK);
    Path recording = folder.resolve("golden/pick_test.test_runs.golden");

    assertEquals(1, test(folder.toString()));
    assertTrue(
        said().contains("there is no recording golden/pick_test.test_runs.golden to compare with"),
        said());
    assertFalse(Files.exists(recording));

    assertEquals(0, test(folder.toString(), "--update-golden"));
    assertTrue(said().contains("recorded golden/pick_test.test_runs.golden"), said());
    assertTrue(Files.exists(recording));
    assertEquals(0, test(folder.toString(), "--seed", "77"));
  }

  @Test
  void aProgramThatDoesSomethingElseThanItsRecordingIsRedAtItsLine() throws IOException {
    golden(PICK);
    assertEquals(0, test(folder.toString(), "--update-golden"));
    golden(PICK.replace("[0.05,", "[0.15,"));

    assertEquals(1, test(folder.toString()));
    assertTrue(said().contains("pick.script:3: error: at 0."), said());
    assertTrue(said().contains("first difference from golden/pick_test.test_runs.golden"), said());

    assertEquals(0, test(folder.toString(), "--update-golden"));
    assertEquals(0, test(folder.toString()));
  }

  @Test
  void aFileThatIsNoRecordingIsNotReplacedByOne() throws IOException {
    golden(PICK);
    Path file = folder.resolve("golden/pick_test.test_runs.golden");
    Files.createDirectories(file.getParent());
    Files.writeString(file, "something else");

    assertEquals(1, test(folder.toString(), "--update-golden"));
    assertTrue(said().contains("is no recording, so it is not replaced"), said());
    assertEquals("something else", Files.readString(file));
    assertEquals(1, test(folder.toString()));
    assertTrue(said().contains("is no golden recording"), said());
  }

  @Test
  void pagesShowTheArmWhereItFirstDiffersAndWhereItWasThen() throws IOException {
    golden(PICK);
    assertEquals(0, test(folder.toString(), "--update-golden"));
    golden(PICK.replace("[0.05,", "[0.15,"));
    Path pages = folder.resolve("pages");

    assertEquals(1, test(folder.toString(), "--html", pages.toString()));
    assertTrue(Files.exists(pages.resolve("red/1-pick_test.test_runs.png")));
    assertTrue(Files.exists(pages.resolve("red/1-pick_test.test_runs-golden.png")));
    String page = Files.readString(pages.resolve("index.html"));
    assertTrue(
        page.contains("The arm at the first difference from the golden recording, 0."), page);
    assertTrue(renderer.lastS() < 0.5);
  }

  @Test
  void aWholeRecordingOfAnEarlierVersionIsComparedWithUntilAnotherTakesItsPlace()
      throws IOException {
    Path red = folder.resolve("red");
    Path whole = folder.resolve("golden/pick_test.test_runs.rec");
    Files.createDirectories(whole.getParent());
    golden(PICK);
    Path broken = folder.resolve("pick_test.script");
    Files.writeString(
        broken, Files.readString(broken).replace("wait_for_end()\n", "wait_for_end()\n  fail()\n"));
    assertEquals(1, test(folder.toString(), "--record-on-failure", red.toString()));
    Files.copy(red.resolve("1-pick_test.test_runs.rec"), whole);
    golden(PICK);
    assertEquals(0, test(folder.toString()));
    golden(PICK.replace("[0.05,", "[0.15,"));
    assertEquals(1, test(folder.toString()));
    assertTrue(said().contains("pick.script:3: error: at 0."), said());

    assertEquals(0, test(folder.toString(), "--update-golden"));
    assertFalse(Files.exists(whole));
    assertEquals(0, test(folder.toString()));
  }

  @Test
  void aRecordingThatWasMadeForLargerDifferencesIsMadeAnew() throws IOException {
    golden(PICK);
    Path tests = folder.resolve("pick_test.script");
    Files.writeString(tests, Files.readString(tests).replace("@golden", "@golden deg=2"));
    assertEquals(0, test(folder.toString(), "--update-golden"));
    golden(PICK);

    assertEquals(1, test(folder.toString()));
    assertTrue(said().contains("was recorded for larger differences"), said());
  }

  @Test
  void casesHaveRecordingsOfTheirOwn() {
    String one = GoldenComparison.name(new TestId("cell/a_test.script", "test_a", "[1, \"x\"]"));
    String other = GoldenComparison.name(new TestId("cell/a_test.script", "test_a", "[1, x]"));

    assertTrue(one.startsWith("cell/golden/a_test.test_a._1_x_."), one);
    assertNotEquals(one, other);
  }

  @Test
  void recordingsAreNotMadeOfProgramsThatMutationBreaks() {
    assertEquals(2, test(folder.toString(), "--update-golden", "--mutate"));
  }
}
