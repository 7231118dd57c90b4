package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.command.FakeDriver;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.debug.ProgramLaunch;
import org.pendant.desktop.debug.RunLines;
import org.pendant.desktop.debug.RunScript;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.fault.ReportedFaults;
import org.pendant.language.source.Source;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.script.GeneratedNames;
import org.pendant.script.vm.ProgramState;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class ProgramRunnerTest {
  private final List<String> told = new ArrayList<>();

  @Test
  void aProgramCanBeStartedAfterCompilingOneHasFailedByAFaultOfOurs() throws Exception {
    try (ReportedFaults faults = new ReportedFaults();
        RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      ProgramDocument document = ProgramDocument.untitled("a.script", "while True:\n  sync()\nend");
      ProgramRunner runner =
          new ProgramRunner(session, new Programs(document), told::add, (line, column) -> {});
      AtomicInteger starts = new AtomicInteger();
      runner.setTexts(
          (program, from) -> ProgramLaunch.of(script(program, starts.getAndIncrement() == 0)));

      EventQueue.invokeAndWait(runner::runOrResume);
      await(runner);
      assertEquals(1, told.size(), told::toString);
      assertTrue(told.getFirst().startsWith("a.script cannot run: internal error"), told::toString);

      EventQueue.invokeAndWait(runner::runOrResume);
      while (session.state().program().state() != ProgramState.RUNNING) {
        EventQueue.invokeAndWait(() -> {});
      }
      assertEquals(1, faults.all().size());
    }
  }

  @Test
  void theProgramOfARunThatABranchGoesBackToIsTheOneThatRunsAgain() {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      ProgramDocument first = ProgramDocument.untitled("a.script", "sleep(1)");
      ProgramDocument second = ProgramDocument.untitled("b.script", "sleep(2)");
      RunScript script = RunScript.whole(first.source());
      ProgramRunner runner =
          new ProgramRunner(session, new Programs(first), told::add, (line, column) -> {});
      runner.startsElsewhere(first, script);
      runner.startsElsewhere(second, RunScript.whole(second.source()));
      List<ProgramDocument> begun = new ArrayList<>();
      runner.beforeEachRun((document, run) -> begun.add(document));
      runner.backTo(first, script);
      assertEquals(Optional.of(first), runner.program());
      assertEquals("sleep(1)", runner.line(1));
      runner.backTo(first, script);
      assertEquals(List.of(first), begun);
    }
  }

  @Test
  void aProgramThatDoesNotCompileNamesThePlaceAsPeopleKnowIt() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      ProgramDocument document = ProgramDocument.untitled("a.script", "sleep(1)\nx = = 2\n");
      ProgramRunner runner =
          new ProgramRunner(session, new Programs(document), told::add, (line, column) -> {});
      runner.nameLinesBy((program, line) -> "node " + line + " of " + program.name());
      EventQueue.invokeAndWait(runner::runOrResume);
      await(runner);
      assertTrue(
          told.getFirst().startsWith("a.script cannot run, node 2 of a.script: "), told::toString);
    }
  }

  private static void await(ProgramRunner runner) throws Exception {
    AtomicBoolean loading = new AtomicBoolean(true);
    while (loading.get()) {
      EventQueue.invokeAndWait(() -> loading.set(runner.loading()));
    }
  }

  /**
   * A program with one node that waits for a driver at {@code host}, and then runs what it sends.
   */
  private static ProgramLaunch waiting(ProgramDocument program, ControlHost host) {
    Installation installation = Installation.NONE.with(parts -> parts.controlHost = host);
    return new ProgramLaunch(
        1,
        installation,
        sent ->
            RunScript.whole(
                Source.of(
                    program.name(),
                    sent.orElseThrow().loop().stream()
                        .map(ControlScript.Line::text)
                        .collect(Collectors.joining("\n")))));
  }

  @Test
  void aProgramStartsWithWhatItsDriverSends() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless());
        FakeDriver driver = new FakeDriver("while True:\n  sync()\nend\n")) {
      ProgramDocument document = ProgramDocument.untitled("a.script", "");
      ProgramRunner runner =
          new ProgramRunner(session, new Programs(document), told::add, (line, column) -> {});
      runner.setTexts((program, from) -> waiting(program, driver.host()));
      EventQueue.invokeAndWait(runner::runOrResume);
      while (session.state().program().state() != ProgramState.RUNNING) {
        EventQueue.invokeAndWait(() -> {});
      }
      assertEquals(1, driver.asked());
      assertEquals(List.of(), told);
    }
  }

  @Test
  void aProgramWithoutItsDriverDoesNotStartAndSaysWhy() throws Exception {
    try (Socket closed = new Socket();
        RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      // bound, so that nobody else gets the port, and nothing listens
      closed.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
      ControlHost gone = new ControlHost("127.0.0.1", closed.getLocalPort());
      ProgramDocument document = ProgramDocument.untitled("a.script", "");
      ProgramRunner runner =
          new ProgramRunner(session, new Programs(document), told::add, (line, column) -> {});
      runner.setTexts((program, from) -> waiting(program, gone));
      EventQueue.invokeAndWait(runner::runOrResume);
      await(runner);
      assertEquals(
          List.of(
              "a.script cannot run: External Control: nobody answers at "
                  + gone.text()
                  + " (connection refused); the driver must be running"),
          told);
      assertEquals(ProgramState.STOPPED, session.state().program().state());
    }
  }

  @Test
  void aStartThatWaitsForItsDriverCanBeStopped() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless());
        FakeDriver silent = new FakeDriver("")) {
      ProgramDocument document = ProgramDocument.untitled("a.script", "");
      ProgramRunner runner =
          new ProgramRunner(session, new Programs(document), told::add, (line, column) -> {});
      runner.setTexts((program, from) -> waiting(program, silent.host()));
      EventQueue.invokeAndWait(
          () -> {
            runner.runOrResume();
            assertTrue(runner.asking());
            assertEquals(
                silent.host().text() + " is being asked for the script", runner.whyLoading());
            runner.stop();
          });
      await(runner);
      assertEquals(
          List.of(
              "a.script cannot run: External Control: stopped while "
                  + silent.host().text()
                  + " was asked for the script"),
          told);
      assertFalse(runner.asking());
    }
  }

  /** The text of a program, or one that makes the compiler throw. */
  private static RunScript script(ProgramDocument program, boolean broken) {
    Source source = broken ? null : program.source();
    return new RunScript(source, program.text(), RunLines.SAME, 0, 0, GeneratedNames.NONE);
  }
}
