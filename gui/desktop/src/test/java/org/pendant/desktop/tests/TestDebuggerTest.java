package org.pendant.desktop.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SharedCell;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.source.TestCase;

/** A test that has the robot of the window for a while. */
@Timeout(60)
final class TestDebuggerTest {
  @TempDir private Path folder;

  private final RobotSession session = RobotSession.start(ControllerOptions.headless());
  private final Programs programs = new Programs(ProgramDocument.untitled("a.script", ""));
  private final List<String> started = Collections.synchronizedList(new ArrayList<>());
  private final CompletableFuture<TestResult> result = new CompletableFuture<>();
  private volatile CompletableFuture<String> told = new CompletableFuture<>();
  private final TestDebugger debugger =
      new TestDebugger(
          session,
          programs,
          (document, script) -> started.add(document.name() + " " + script.lines().toShown(2)),
          sentence -> {
            if (!sentence.startsWith("Breakpoints in")) {
              told.complete(sentence);
            }
          },
          result::complete);

  @BeforeEach
  void hurry() {
    session.setPace(new Pace.Unlimited());
  }

  @AfterEach
  void close() {
    session.close();
  }

  private String debugAgain(String... lines) throws Exception {
    told = new CompletableFuture<>();
    return debug(lines);
  }

  /** Debugs the only test of a file; the robot is there again when this returns what was told. */
  private String debug(String... lines) throws Exception {
    Files.write(folder.resolve("a_test.script"), List.of(lines));
    FolderFiles files = new FolderFiles(folder, Map.of());
    TestSetup setup = new TestSetup(files, ControllerOptions.headless());
    TestCase test =
        new TestRunner(
                files,
                TestJob.settings(setup, 1),
                _ -> true,
                _ -> {},
                files.goldens(false),
                Optional.empty())
            .plan(List.of("a_test.script"))
            .tests()
            .getFirst();
    EventQueue.invokeAndWait(() -> debugger.debug(setup, test, 1));
    String why = told.get(60, TimeUnit.SECONDS);
    EventQueue.invokeAndWait(() -> assertTrue(debugger.test().isEmpty()));
    return why;
  }

  @Test
  void aTestRunsInTheWindowAndTheOwnRobotComesBack() throws Exception {
    ControllerOptions own = session.options();
    String why = debug("def test_a():", "  sleep(0.1)", "end");
    assertEquals("test_a passed", why);
    assertEquals(new TestId("a_test.script", "test_a", ""), result.get().id());
    assertEquals(List.of("a_test.script 2"), started);
    assertEquals(own.robotId(), session.options().robotId());
    assertTrue(session.branchRefusal(0).isEmpty());
  }

  @Test
  void theScriptThatATestStartsIsTheUsersAndNotOneThatOthersHaveSent() throws Exception {
    Files.write(folder.resolve("pick.script"), List.of("sleep(0.1)", "sync()"));
    String why = debug("def test_a():", "  start(\"pick.script\")", "  wait_for_end()", "end");
    assertEquals("test_a passed", why);
    assertEquals(List.of("pick.script 2"), started);
    assertEquals(0, session.strangersStarted());
  }

  private void cell() throws Exception {
    Files.writeString(
        folder.resolve("two.scene.json"),
        """
        {
          "arms": [
            {"name": "near"},
            {"name": "far", "base": [1, 0, 0, 0, 0, 3], "program": "raise.script"}
          ],
          "wires": [["far.digital_out[0]", "near.digital_in[0]"]]
        }
        """);
    Files.writeString(
        folder.resolve("raise.script"), "sleep(0.3)\nset_standard_digital_out(0, True)\n");
  }

  private String debugInCell() throws Exception {
    return debug(
        "# @scene two.scene.json",
        "def test_a():",
        "  eventually(get_standard_digital_in(0), within=1)",
        "end");
  }

  @Test
  void aTestOfACellBringsAllItsControllersAndTheOwnRobotComesBack() throws Exception {
    cell();
    List<String> names = Collections.synchronizedList(new ArrayList<>());
    session.addCellListener(
        (member, state) -> {
          if (session.lent() && !names.contains(member.name())) {
            names.add(member.name());
          }
        });
    assertEquals("test_a passed", debugInCell());
    assertEquals(List.of("near", "far"), names);
    assertFalse(session.inCell());
    assertFalse(session.lent());
  }

  @Test
  void aCellComesBackAsWell() throws Exception {
    cell();
    session.restart(SharedCell.setup());
    session.show("right");
    assertEquals("test_a passed", debugInCell());
    assertEquals(
        List.of("left", "right", "cell"),
        session.members().stream().map(SessionMember::name).toList());
    assertEquals("right", session.shown().name());
    assertEquals("test_a passed", debugAgain("def test_a():", "  sleep(0.1)", "end"));
    assertEquals("right", session.shown().name());
  }

  @Test
  void aTestThatIsRedSaysWhy() throws Exception {
    String why = debug("def test_a():", "  assert_equal(1, 2)", "end");
    assertEquals("test_a is red: assert_equal: is 1, must be 2", why);
    assertEquals(TestStatus.FAILED, result.get().status());
  }

  @Test
  void whatCannotBeDebuggedIsRefusedBeforeAnythingChanges() throws Exception {
    String why = debug("def test_a():", "  start(\"none.script\")", "end");
    assertTrue(why.startsWith("test_a cannot be debugged: start: none.script: "), why);
    assertEquals(List.of(), started);
  }
}
