package org.pendant.desktop.program.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.language.service.Completion;
import org.pendant.language.service.GuestExpression;
import org.pendant.language.source.Diagnostic;

final class ExpressionScopeTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final ExpressionScope scope =
      ExpressionScope.of(EveryNode.tree(controller.state()), EveryNode.installation());

  private GuestExpression read(String expression) {
    return GuestExpression.of(scope.source(), controller.builtins(), scope.line(), expression);
  }

  private String problem(String expression) {
    return read(expression).problem().map(Diagnostic::message).orElse("");
  }

  @Test
  void knowsVariablesOfTreeAndInstallation() {
    assertEquals("", problem("count + parts + pallet_count + turn + cycle > 1"));
    assertEquals("", problem("norm(Waypoint_1_q) > 1"));
    assertEquals("", problem("speed_now > 3"));
  }

  @Test
  void knowsWhatTheProgramDefines() {
    assertEquals("", problem("grip(2) > 1"));
    assertTrue(problem("grip() > 1").contains("grip"), problem("grip() > 1"));
  }

  @Test
  void tellsNamesThatNobodyHasGiven() {
    assertTrue(problem("unknown_thing > 1").contains("unknown_thing"));
  }

  @Test
  void completesNames() {
    List<String> labels = read("par").completions(3).stream().map(Completion::label).toList();
    assertTrue(labels.contains("parts"), labels.toString());
  }

  @Test
  void valuesOfAnyTypeArePutIntoACondition() {
    String before = ExpressionScope.ANYTHING + " == (";
    assertEquals("", problem(before + "p[0, 0, 0, 0, 0, 0])"));
    assertEquals("", problem(before + "\"text\")"));
    assertEquals("", problem(before + "[1, 2])"));
    assertTrue(problem(before + "1 +)").contains("expected"));
  }
}
