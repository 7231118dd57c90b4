package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.editors.dap.DebugClient.refusal;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.eclipse.lsp4j.debug.ContinueArguments;
import org.eclipse.lsp4j.debug.ExceptionBreakpointsFilter;
import org.eclipse.lsp4j.debug.PauseArguments;
import org.eclipse.lsp4j.debug.StepBackArguments;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An adapter says what people read in the language that their editor names. */
class DebugLanguageTest {
  private static final String FAILS =
      """
      def place(i):
        textmsg("the program has ended")
        return [1, 2][i]
      end
      count = 0
      sleep(0.1)
      place(7)
      """;

  @TempDir private Path folder;

  private static List<String> filters(DebugClient client) {
    return Arrays.stream(client.initialize().getExceptionBreakpointFilters())
        .map(ExceptionBreakpointsFilter::getLabel)
        .toList();
  }

  @Test
  void aClientIsToldInItsLanguageAndOutputOfProgramsStays() throws Exception {
    try (DebugClient client = DebugClient.of(folder, FAILS).speaking("de-AT")) {
      assertEquals(List.of("Laufzeitfehler", "Schutzstopps"), filters(client));
      client.launch();
      assertEquals("kein Programm läuft", refusal(client.server().pause(new PauseArguments())));
      assertEquals(
          List.of("Auf die nächste Anweisung verschoben", "null"),
          Arrays.stream(client.breakpoints(1, 7))
              .map(each -> String.valueOf(each.getMessage()))
              .toList());
      client.configured();
      client.stop();
      assertEquals(
          Set.of("Lokale Variablen", "Globale Variablen", "Register", "Roboter", "I/O"),
          client.scopes().keySet());
      StepBackArguments back = new StepBackArguments();
      back.setThreadId(1);
      client.server().stepBack(back).join();
      StoppedEventArguments past = client.stop();
      assertEquals("step", past.getReason());
      assertEquals("In der Vergangenheit, bei 0.002 s; jetzt ist 0.102 s", past.getDescription());
      client.server().continue_(new ContinueArguments()).join();
      client.stop();
      var _ = client.breakpoints(new int[0]);
      client.resume();
      assertEquals(1, client.end());
      assertEquals(
          List.of(
              "the program has ended",
              folder.resolve("program.script") + ":3:10: Fehler: Index ist 7, muss 0 bis 1 sein",
              "  return [1, 2][i]",
              "         ^~~~~~~~~",
              "  in place, Zeile 3",
              "  in program, Zeile 7"),
          client.output().stream().flatMap(each -> each.getOutput().lines()).toList());
    }
  }

  @Test
  void twoClientsOfOneProcessAreToldInTheirOwnLanguages() throws Exception {
    try (DebugClient chinese = DebugClient.of(folder, FAILS).speaking("zh-cn");
        DebugClient other = DebugClient.of(folder, FAILS).speaking("fr");
        DebugClient english = DebugClient.of(folder, FAILS)) {
      assertEquals(List.of("运行时错误", "保护性停止"), filters(chinese));
      assertEquals(List.of("Runtime errors", "Protective stops"), filters(other));
      assertEquals(List.of("Runtime errors", "Protective stops"), filters(english));
      assertEquals("没有启动程序", refusal(chinese.server().threads()));
      assertEquals("no program was launched", refusal(other.server().threads()));
      assertEquals("no program was launched", refusal(english.server().threads()));
    }
  }
}
