package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.language.source.Source;
import org.pendant.script.function.ScriptPlace;

/** What lines of the log say about where they come from. */
final class LogPlacesTest {
  private static final long LONG = 5_000;

  private final Controller controller = new Controller(ControllerOptions.headless());

  private List<LogEntry> logOf(String program) {
    start(program);
    controller.runUntil(() -> controller.state().program().ending().isPresent(), LONG);
    return controller.logSince(0);
  }

  private void start(String program) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                controller.load(Source.of("p.script", program)).program().orElseThrow()));
    controller.advance();
  }

  private static Optional<ScriptPlace> at(int thread, String name, int line) {
    return Optional.of(new ScriptPlace("p.script", thread, name, line));
  }

  @Test
  void textOfEachThreadHasItsLine() {
    List<LogEntry> log =
        logOf(
            """
            def p():
              thread watch():
                textmsg("watching")
              end
              t = run watch()
              textmsg("main")
              join t
            end
            """);
    assertEquals(List.of("main", "watching"), log.stream().map(LogEntry::text).sorted().toList());
    for (LogEntry entry : log) {
      assertEquals(entry.text().equals("main") ? at(0, "p", 6) : at(1, "watch", 3), entry.place());
    }
  }

  @Test
  void textOfATranslatedFunctionHasItsLine() {
    List<LogEntry> log =
        logOf(
            """
            def p():
              def hot(i):
                if i == 20000:
                  textmsg("last")
                end
                return i + 1
              end
              i = 0
              while i < 20001:
                i = hot(i)
              end
            end
            """);
    assertEquals(at(0, "p", 4), log.getFirst().place());
  }

  @Test
  void whatEndsAProgramHasItsLineAndCode() {
    LogEntry ending =
        logOf(
                """
                def p():
                  thread watch():
                    x = sqrt(-1)
                  end
                  t = run watch()
                  sleep(9)
                end
                """)
            .getLast();
    assertEquals(Origin.ENDING, ending.origin());
    assertEquals(at(1, "watch", 3), ending.place());
    assertEquals("value-out-of-range", ending.code());
  }

  @Test
  void aSafetyStopHasTheLineOfTheMainThread() {
    start("def p():\n  sleep(1)\n  sleep(9)\nend\n");
    controller.runUntil(() -> controller.state().timeS() > 2, LONG);
    var _ = controller.submit(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    controller.advance();
    LogEntry stop = controller.logSince(0).getLast();
    assertEquals(Origin.SAFETY, stop.origin());
    assertEquals(Level.WARNING, stop.level());
    assertEquals("C100A5", stop.code());
    assertEquals(at(0, "p", 3), stop.place());
  }

  @Test
  void aSecondaryProgramHasItsOwnLines() {
    start("def p():\n  sleep(9)\nend\n");
    var _ =
        controller.submit(
            new ProgramCommand.RunSecondary(
                controller
                    .load(
                        Source.of("s.script", "sec s():\n  textmsg(\"hi\")\n  x = sqrt(-1)\nend\n"))
                    .program()
                    .orElseThrow()));
    controller.advance();
    List<LogEntry> log = controller.logSince(0);
    assertEquals(Optional.of(new ScriptPlace("s.script", 0, "s", 2)), log.get(0).place());
    assertEquals(Optional.of(new ScriptPlace("s.script", 0, "s", 3)), log.get(1).place());
  }

  @Test
  void linesOfAProtocolAreMarkedAsSuch() {
    var _ = controller.submit(new MessageCommand.WriteLog(Level.WARNING, "client gone"));
    controller.advance();
    LogEntry entry = controller.logSince(0).getLast();
    assertEquals(Origin.PROTOCOL, entry.origin());
    assertEquals("client gone", entry.text());
    assertEquals(Optional.empty(), entry.place());
  }
}
