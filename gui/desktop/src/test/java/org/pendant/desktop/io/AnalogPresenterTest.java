package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.IoCommand;
import org.pendant.script.vm.Program;

final class AnalogPresenterTest {
  private static final double TOLERANCE = 1e-9;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final List<String> told = new ArrayList<>();
  private final Forcing forcing = new Forcing(controller::submit, Runnable::run, told::add);
  private final AnalogPresenter input = new AnalogPresenter(AnalogBank.TOOL_IN, 1, forcing);
  private final AnalogPresenter output = new AnalogPresenter(AnalogBank.STANDARD_OUT, 0, forcing);

  private void frame() {
    controller.advance();
    input.take(controller.state());
    output.take(controller.state());
  }

  private void start(String text) {
    Program program = TestController.program(controller, text);
    CompletableFuture<?> started = controller.submit(new ProgramCommand.StartProgram(program));
    frame();
    assertTrue(started.isDone());
  }

  @Test
  void anInputIsForcedByTyping() {
    frame();
    input.set("7,25 V");
    assertEquals(7.25, input.value(), "what was asked for shows at once");
    assertTrue(input.forced());
    frame();
    assertEquals(7.25, controller.state().signals().analog().toolIn1().value());
    assertEquals(0.725, input.valueRatio(), TOLERANCE);
    input.set("0");
    frame();
    assertFalse(input.forced());
  }

  @Test
  void whatIsTypedIsInTheUnitOfTheDomain() {
    frame();
    input.setDomain(AnalogDomain.CURRENT);
    assertEquals(AnalogDomain.CURRENT, input.domain(), "what was asked for shows at once");
    input.set("12");
    frame();
    assertEquals(0.012, controller.state().signals().analog().toolIn1().value());
    assertEquals(
        "'3.9' must be 4 to 20 mA",
        assertThrows(IllegalArgumentException.class, () -> input.set("3.9")).getMessage());
    assertEquals(
        "'5 V' must be 4 to 20 mA",
        assertThrows(IllegalArgumentException.class, () -> input.set("5 V")).getMessage());
  }

  @Test
  void anOutputIsSetByItsSliderWhileNoProgramRuns() {
    frame();
    assertTrue(output.settable());
    output.setRatio(0.5);
    assertEquals(0.012, output.value(), TOLERANCE);
    assertFalse(output.forced());
    frame();
    assertEquals(0.012, controller.state().signals().analog().standardOut0().value(), TOLERANCE);
    start("def busy():\n  sleep(1)\nend\n");
    assertFalse(output.settable());
    assertFalse(output.domainSettable());
    assertTrue(input.settable());
    output.setRatio(1);
    frame();
    assertEquals(0.012, output.value(), TOLERANCE);
    assertEquals(
        List.of(
            "analog_out[0] belongs to program busy: outputs are set by hand only while none runs"),
        told);
  }

  @Test
  void allForcedInputsAreReleasedTogether() {
    frame();
    input.set("5");
    input.setDomain(AnalogDomain.CURRENT);
    input.set("20");
    frame();
    assertEquals(1, forcing.count());
    forcing.releaseAll();
    assertEquals(0, forcing.count());
    frame();
    assertEquals(0.004, input.value());
    input.setDomain(AnalogDomain.VOLTAGE);
    frame();
    assertEquals(0, input.value());
  }

  @Test
  void aRefusedInputIsNotForced() {
    var _ = controller.submit(new IoCommand.ClaimSignal("PLC", "tool_analog_in[1]"));
    frame();
    input.set("5");
    frame();
    assertFalse(input.forced());
    assertEquals(0, input.value());
    assertEquals(List.of("tool_analog_in[1] is in use by PLC"), told);
  }
}
