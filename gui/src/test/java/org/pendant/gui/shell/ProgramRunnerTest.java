package org.pendant.gui.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.machine.ProgramState;
import org.pendant.gui.debug.RunScript;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.Programs;
import org.pendant.gui.session.Session;
import org.pendant.language.source.Source;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class ProgramRunnerTest {
  private final List<String> told = new ArrayList<>();

  @Test
  void aProgramCanBeStartedAfterCompilingOneHasFailedByAFaultOfOurs() throws Exception {
    try (ReportedFaults faults = new ReportedFaults();
        Session session = Session.start(ControllerOptions.headless())) {
      ProgramDocument document = ProgramDocument.untitled("a.script", "while True:\n  sync()\nend");
      ProgramRunner runner =
          new ProgramRunner(session, new Programs(document), told::add, (line, column) -> {});
      AtomicInteger starts = new AtomicInteger();
      runner.setTexts((program, from) -> script(program, starts.getAndIncrement() == 0));

      EventQueue.invokeAndWait(runner::runOrResume);
      while (runner.loading()) {
        EventQueue.invokeAndWait(() -> {});
      }
      assertEquals(1, told.size(), told::toString);
      assertTrue(told.getFirst().startsWith("a.script cannot run: internal error"), told::toString);
      assertFalse(runner.loading());

      EventQueue.invokeAndWait(runner::runOrResume);
      while (session.state().program().state() != ProgramState.RUNNING) {
        EventQueue.invokeAndWait(() -> {});
      }
      assertEquals(1, faults.all().size());
    }
  }

  /** The text of a program, or one that makes the compiler throw. */
  private static RunScript script(ProgramDocument program, boolean broken) {
    Source none = null;
    return RunScript.whole(broken ? none : program.source());
  }
}
