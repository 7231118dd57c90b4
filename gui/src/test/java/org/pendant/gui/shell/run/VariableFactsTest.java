package org.pendant.gui.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.variables.VariableSamples;
import org.pendant.language.source.Source;

final class VariableFactsTest {

  private static VariableSamples samples(String... lines) {
    Controller controller = new Controller(ControllerOptions.headless());
    Source source = Source.of("test.script", String.join("\n", lines) + "\n");
    var _ =
        controller.submit(
            new Command.StartProgram(controller.load(source).program().orElseThrow()));
    controller.advance();
    return controller.state().variables();
  }

  @Test
  void favouritesComeFirstAndStringsAreInQuotes() {
    VariableSamples samples =
        samples("def p():", "  a = 1", "  name = \"bolt\"", "  sleep(1)", "  late = 2", "end");
    VariableFacts facts = VariableFacts.of(samples, Set.of("name"));
    assertEquals(
        List.of(
            new VariableFacts.Row("name", "\"bolt\"", true),
            new VariableFacts.Row("a", "1", false),
            new VariableFacts.Row("late", "\u2013", false)),
        facts.rows());
    assertEquals(0, facts.more());
  }

  @Test
  void whatHasNoRoomIsCounted() {
    StringBuilder text = new StringBuilder("def p():\n");
    for (int i = 0; i < 25; i++) {
      text.append("  v").append(i).append(" = 1\n");
    }
    VariableFacts facts =
        VariableFacts.of(samples(text.append("  sleep(1)\nend").toString()), Set.of("v24"));
    assertEquals(VariableFacts.MOST, facts.rows().size());
    assertEquals("v24", facts.rows().getFirst().name());
    assertEquals(25 - VariableFacts.MOST, facts.more());
  }

  @Test
  void thereIsNothingBeforeTheFirstProgram() {
    assertEquals(new VariableFacts(List.of(), 0), VariableFacts.of(VariableSamples.NONE, Set.of()));
  }
}
