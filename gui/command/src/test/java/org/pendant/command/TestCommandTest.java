package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class TestCommandTest {
  private static final String PICK =
      """
      def pick():
        def height_of(n):
          return n * 0.05
        end
        set_standard_digital_out(0, True)
        sleep(0.1)
      end
      """;
  private static final String TESTS =
      """
      import_script("pick.script")
      # @tag fast
      def test_height():
        assert_near(height_of(2), 0.1)
      end
      def test_runs():
        start("pick.script")
        wait_for_end()
      end
      """;
  private static final String RED =
      """
      def test_red():
        movej([0, -1.5, -1.5, -1.5, 1.5, 0])
        fail("so it is")
      end
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @BeforeEach
  void aProgramWithTests() throws IOException {
    Files.writeString(folder.resolve("pick.script"), PICK);
    Files.writeString(folder.resolve("pick_test.script"), TESTS);
  }

  private int test(String... words) {
    List<String> all = new ArrayList<>(List.of("test", "--color", "never"));
    all.addAll(List.of(words));
    output.reset();
    errors.reset();
    DesktopServices none = new DesktopServices(Optional::empty, Optional::empty);
    return new Pendant(new Console(output, errors), none).run(all).number();
  }

  private String said() {
    return output.toString(StandardCharsets.UTF_8).replace(folder + "/", "");
  }

  private void red() throws IOException {
    Files.writeString(folder.resolve("red_test.script"), RED);
  }

  @Test
  void theTestsOfAFolderAreRun() {
    assertEquals(0, test(folder.toString(), "--seed", "7"));
    assertTrue(said().startsWith("✓ pick_test.script: 2 passed in "), said());
    assertTrue(said().contains("(seed 7)"), said());
  }

  @Test
  void aRedTestIsExitCodeOneAndABrokenFileThree() throws IOException {
    red();
    assertEquals(1, test(folder.toString()));
    assertTrue(said().contains("red_test.script:3:3: error: so it is: the test says so"), said());

    Files.writeString(folder.resolve("red_test.script"), "def test_x():\n  y = no_such(1)\nend\n");
    assertEquals(3, test(folder.toString()));
    assertTrue(said().contains("red_test.script:2:7: error: "), said());
  }

  @Test
  void testsAreChosenByNameAndTagAndListed() {
    assertEquals(0, test(folder.toString(), "--list", "--tag", "fast"));
    assertEquals("pick_test.script:test_height\n", said());

    assertEquals(0, test(folder.toString(), "--list", "--filter", "runs"));
    assertEquals("pick_test.script:test_runs\n", said());

    assertEquals(2, test(folder.toString(), "--filter", "nothing has this"));
  }

  @Test
  void aTargetThatNothingListensAtIsTold() throws IOException {
    int port;
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = free.getLocalPort();
    }

    assertEquals(69, test(folder.toString(), "--target", "127.0.0.1:" + (port - 30_004)));
    assertEquals(
        "pendant test: 127.0.0.1: port "
            + port
            + " (RTDE): cannot be reached, nothing listens there or it is off\n",
        errors.toString(StandardCharsets.UTF_8));
  }

  @Test
  void noTargetIsAskedForWhereNothingCanRunThere() throws IOException {
    Files.writeString(folder.resolve("wire_test.script"), "def test_wired():\n  wire(0, 5)\nend\n");

    assertEquals(
        0, test(folder.toString(), "--target", "127.0.0.1:1", "--filter", "wired", "--verbose"));
    assertTrue(said().contains("test_wired: --target: `wire` sets an input"), said());
  }

  @Test
  void whatNeedsAControllerHereIsRefusedForATarget() {
    assertEquals(2, test(folder.toString(), "--target", "127.0.0.1", "--coverage"));
    assertEquals(2, test(folder.toString(), "--target", "127.0.0.1", "--watch"));
    assertEquals(2, test(folder.toString(), "--target", "127.0.0.1", "--mutate"));
    assertEquals(2, test(folder.toString(), "--target", "http://robot"));
  }

  @Test
  void partsOfTheTestsAreRunSideBySide() {
    assertEquals(0, test(folder.toString(), "--list", "--shard", "2/2"));
    assertEquals("pick_test.script:test_runs\n", said());
    assertEquals(2, test(folder.toString(), "--shard", "3/2"));
  }

  @Test
  void aReportReplacesAnEarlierOneAndNothingElse() throws IOException {
    Path report = folder.resolve("tests.xml");
    assertEquals(0, test(folder.toString(), "--junit", report.toString(), "--seed", "3"));
    String first = Files.readString(report);
    assertEquals(0, test(folder.toString(), "--junit", report.toString(), "--seed", "3"));
    assertEquals(first, Files.readString(report));

    Files.writeString(report, "something else");
    assertEquals(2, test(folder.toString(), "--junit", report.toString()));
    assertEquals("something else", Files.readString(report));
    assertEquals(0, test(folder.toString(), "--junit", report.toString(), "--force"));
  }

  @Test
  void noReportIsEverWrittenOntoAProgramThatATestStarts() throws IOException {
    String program = folder.resolve("pick.script").toString();

    assertEquals(2, test(folder.toString(), "--force", "--tap", program));
    assertEquals(PICK, Files.readString(folder.resolve("pick.script")));
  }

  @Test
  void coverageIsPrintedAndWritten() throws IOException {
    Path lcov = folder.resolve("c.info");

    assertEquals(0, test(folder.toString(), "--coverage", "--lcov", lcov.toString()));
    assertTrue(said().contains("pick.script       100 %"), said());
    assertTrue(Files.readString(lcov).contains("FN:2,height_of"), Files.readString(lcov));
  }

  @Test
  void redTestsAreRecorded() throws IOException {
    red();
    Path recordings = folder.resolve("red");

    assertEquals(1, test(folder.toString(), "--record-on-failure", recordings.toString()));
    assertTrue(Files.size(recordings.resolve("1-red_test.test_red.rec")) > 1000);
    assertFalse(Files.exists(recordings.resolve("1-red_test.test_red.png")));
  }

  @Test
  void aFolderWithoutTestsIsAMistakeOfTheCommandLine() throws IOException {
    Path empty = Files.createDirectory(folder.resolve("empty"));

    assertEquals(2, test(empty.toString()));
    assertTrue(errors.toString(StandardCharsets.UTF_8).contains("no file *_test.script in "));
  }
}
