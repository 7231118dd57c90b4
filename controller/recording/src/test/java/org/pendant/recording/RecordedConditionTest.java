package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariableSamples;

final class RecordedConditionTest {
  private static final String PROGRAM =
      """
      i = 3
      x = 2.5
      list = [1, 2, 3]
      part = struct(size=4)
      word = "bolt"
      on = True
      """;

  private static VariableSamples samples() {
    Controller controller = new Controller(ControllerOptions.headless());
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, PROGRAM)));
    controller.advance();
    controller.advance();
    return controller.state().variables();
  }

  private static Optional<Boolean> holds(String condition) {
    return new RecordedCondition(condition).holds(samples());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "i == 3",
        "i > 2 and x < 3",
        "list[1] == 2",
        "list == [1, 2, 3]",
        "part.size * 2 == 8",
        "word == \"bolt\"",
        "on",
        "not (i == 4)",
        "-i < 0 or unknown == 1"
      })
  void holdsByTheValuesOfVariables(String condition) {
    assertEquals(Optional.of(true), holds(condition));
  }

  @Test
  void isComputedAsAnExpression() {
    assertEquals(
        Optional.of("7.5"), new RecordedCondition("i * x").value(samples()).map(Value::text));
    assertEquals(Optional.empty(), new RecordedCondition("unknown").value(samples()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"i == 4", "i > 2 and x > 3", "not on"})
  void doesNotHoldByTheValuesOfVariables(String condition) {
    assertEquals(Optional.of(false), holds(condition));
  }

  @ParameterizedTest
  @ValueSource(strings = {"get_digital_in(0)", "unknown == 1", "i +", "i < word", "i == 3: sync()"})
  void cannotBeToldFromWhatIsNoVariable(String condition) {
    assertEquals(Optional.empty(), holds(condition));
  }

  @Test
  void nothingIsKnownBeforeTheFirstProgram() {
    assertEquals(List.of(), VariableSamples.NONE.globals());
    assertEquals(Optional.empty(), new RecordedCondition("i == 3").holds(VariableSamples.NONE));
  }
}
