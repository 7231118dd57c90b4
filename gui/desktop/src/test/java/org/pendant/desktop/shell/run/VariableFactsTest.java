package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.script.variables.VariableSamples;

final class VariableFactsTest {

  private static VariableSamples samples(String... lines) {
    Controller controller = new Controller(ControllerOptions.headless());
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(controller, String.join("\n", lines) + "\n")));
    controller.advance();
    return controller.state().variables();
  }

  @Test
  void favouritesComeFirstAndStringsAreInQuotes() {
    VariableSamples samples =
        samples("def p():", "  a = 1", "  name = \"bolt\"", "  sleep(1)", "  late = 2", "end");
    VariableFacts facts = VariableFacts.of(samples, Set.of("name"), each -> false, List.of());
    assertEquals(
        List.of(
            new VariableFacts.Row("name", "\"bolt\"", true, false),
            new VariableFacts.Row("a", "1", false, false),
            new VariableFacts.Row("late", "\u2013", false, false)),
        facts.rows());
    assertEquals(0, facts.more());
  }

  @Test
  void thoseOfTheInstallationAreThereAtAnyTime() {
    List<InstallationVariable> installed =
        List.of(
            new InstallationVariable("parts", "7", false),
            new InstallationVariable("shift", "2", true));
    assertEquals(
        List.of(
            new VariableFacts.Row("shift", "2", true, true),
            new VariableFacts.Row("parts", "7", false, true)),
        VariableFacts.of(VariableSamples.NONE, Set.of(), each -> false, installed).rows());
    assertEquals(
        List.of(
            new VariableFacts.Row("shift", "2", true, true),
            new VariableFacts.Row("parts", "8", false, true)),
        VariableFacts.of(
                samples("def p():", "  parts = 8", "  sleep(1)", "end"),
                Set.of(),
                each -> false,
                installed)
            .rows());
  }

  @Test
  void whatIsHiddenIsLeftOutUnlessItIsAFavourite() {
    VariableSamples samples =
        samples("def p():", "  At_p = 1", "  At_q = 2", "  placed = 3", "  sleep(1)", "end");
    VariableFacts facts =
        VariableFacts.of(samples, Set.of("At_q"), each -> each.startsWith("At_"), List.of());
    assertEquals(
        List.of("At_q", "placed"), facts.rows().stream().map(VariableFacts.Row::name).toList());
    assertEquals(0, facts.more());
  }

  @Test
  void whatHasNoRoomIsCounted() {
    StringBuilder text = new StringBuilder("def p():\n");
    for (int i = 0; i < 25; i++) {
      text.append("  v").append(i).append(" = 1\n");
    }
    VariableFacts facts =
        VariableFacts.of(
            samples(text.append("  sleep(1)\nend").toString()),
            Set.of("v24"),
            each -> false,
            List.of());
    assertEquals(VariableFacts.MOST, facts.rows().size());
    assertEquals("v24", facts.rows().getFirst().name());
    assertEquals(25 - VariableFacts.MOST, facts.more());
  }

  @Test
  void thereIsNothingBeforeTheFirstProgram() {
    assertEquals(
        new VariableFacts(List.of(), 0),
        VariableFacts.of(VariableSamples.NONE, Set.of(), each -> false, List.of()));
  }
}
