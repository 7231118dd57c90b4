package org.pendant.controller.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.language.source.Source;
import org.pendant.script.value.Value;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

class VariableLiteralTest {
  /** What a program leaves in a variable to which it has assigned a literal. */
  private static Value assigned(String literal) {
    Controller controller = new Controller(ControllerOptions.headless());
    LoadResult loadResult =
        controller.load(Source.of("v.script", "def f():\n  global v = " + literal + "\nend\n"));
    var _ = controller.submit(new ProgramCommand.StartProgram(loadResult.program().orElseThrow()));
    controller.advance();
    controller.runUntil(() -> controller.state().program().state() == ProgramState.STOPPED, 1000);
    return controller.globals().get("v");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "True",
        "12",
        "-3",
        "0.1",
        "1.0",
        "1.0E-7",
        "\"two words\"",
        "p[0.1, 0.2, 0.3, 0.0, 3.1, 0.0]",
        "[1, 2, 3]",
        "[1.0, 2.5]",
        "[True, False]",
        "[\"a\", \"b\"]",
        "[[1, 2], [3, 4]]",
        "[[1.0, 2.0], [3.0, 4.0]]",
        "[p[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]]",
        "struct(count=1, name=\"x\")",
      })
  void aProgramThatBeginsWithTheLiteralLeavesItAgain(String literal) {
    Value value = assigned(literal);
    assertEquals(Optional.of(literal), VariableLiteral.of(value));
  }

  @Test
  void someValuesHaveNone() {
    assertEquals(Optional.empty(), VariableLiteral.of(Value.of(Double.NaN)));
    assertEquals(Optional.empty(), VariableLiteral.of(Value.of(Double.POSITIVE_INFINITY)));
    assertEquals(Optional.empty(), VariableLiteral.of(Value.of("a \"quoted\" word")));
    assertEquals(Optional.empty(), VariableLiteral.of(Value.of("two\nlines")));
    assertEquals(Optional.empty(), VariableLiteral.of(Value.of("x".repeat(30_000))));
  }
}
