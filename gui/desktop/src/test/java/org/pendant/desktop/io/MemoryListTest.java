package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.script.vm.Program;

final class MemoryListTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final List<String> told = new ArrayList<>();
  private final Forcing forcing = new Forcing(controller::submit, Runnable::run, told::add);
  private final Map<String, String> remembered = new HashMap<>();
  private final SignalLabels labels = new SignalLabels(new MemorySettings(remembered));
  private final MemoryList floats = list(RegisterDirection.INPUT, RegisterKind.FLOAT);
  private final MemoryList integers = list(RegisterDirection.OUTPUT, RegisterKind.INTEGER);
  private final MemoryList flags = new MemoryList(new Memory.Flags(), forcing, labels);

  private MemoryList list(RegisterDirection direction, RegisterKind kind) {
    return new MemoryList(new Memory.Registers(direction, kind), forcing, labels);
  }

  @BeforeEach
  void frame() {
    controller.advance();
    for (MemoryList each : List.of(floats, integers, flags)) {
      each.take(controller.state());
    }
  }

  private void start(String text) {
    Program program = TestController.program(controller, text);
    var _ = controller.submit(new ProgramCommand.StartProgram(program));
    frame();
  }

  @Test
  void onlyPlacesInUseAreShownAtFirst() {
    assertEquals(List.of(), integers.shown());
    start("write_output_integer_register(30, 5)\nwrite_output_integer_register(2, -1)\n");
    assertEquals(List.of(2, 30), integers.shown());
    start("write_output_integer_register(30, 0)\n");
    assertEquals(List.of(2, 30), integers.shown(), "they stay, or rows would come and go");
    integers.name(7, " parts ");
    integers.filter("", true);
    assertEquals(List.of(2, 7, 30), integers.shown());
    integers.filter("", false);
    assertEquals(48, integers.shown().size());
  }

  @Test
  void placesAreFoundByNumberAndByName() {
    floats.name(13, "Belt speed");
    floats.filter("4", true);
    assertEquals(List.of(4), floats.shown());
    floats.filter("SPEED", true);
    assertEquals(List.of(13), floats.shown());
    floats.filter("input_float_register[9]", true);
    assertEquals(List.of(9), floats.shown());
    flags.filter("nothing", false);
    assertEquals(List.of(), flags.shown());
  }

  @Test
  void anInputIsForcedAndReleased() {
    floats.set(3, "0,25");
    assertEquals("0.25", floats.text(3), "what was asked for shows at once");
    frame();
    assertEquals(0.25, controller.state().signals().inputs().floating(3));
    assertTrue(floats.forced(3));
    forcing.releaseAll();
    frame();
    assertEquals("0", floats.text(3));
    assertFalse(floats.forced(3));
  }

  @Test
  void flagsAndOutputsAreSetWhileNoProgramRuns() {
    flags.toggle(5);
    integers.set(0, "-2147483648");
    frame();
    assertEquals(1 << 5, controller.state().io().flags());
    assertEquals("-2147483648", integers.brief(0));
    assertFalse(flags.forced(5));
    assertTrue(flags.settable());
    start("def busy():\n  sleep(1)\nend\n");
    assertFalse(flags.settable());
    assertTrue(floats.settable());
  }

  @Test
  void longNumbersAreShownShort() {
    floats.set(0, "0.30000000000000004");
    floats.set(1, "1.23456789e-300");
    frame();
    assertEquals("0.3", floats.brief(0));
    assertEquals("0.30000000000000004", floats.text(0));
    assertEquals("1.23457E-300", floats.brief(1));
  }

  @Test
  void whatAPlaceCannotHoldIsRefused() {
    assertEquals(
        "'1.5' must be a whole number of 32 bits",
        assertThrows(IllegalArgumentException.class, () -> integers.set(0, "1.5")).getMessage());
    assertEquals(
        "'NaN' must be a number",
        assertThrows(IllegalArgumentException.class, () -> floats.check("NaN")).getMessage());
    assertThrows(IllegalArgumentException.class, () -> integers.check("2147483648"));
    assertThrows(IllegalArgumentException.class, () -> floats.check("x"));
  }

  @Test
  void listsAreCalledByTheirKind() {
    assertEquals("Float input registers", floats.memory().title());
    assertEquals("input-float-register-3", floats.memory().id(3));
    assertEquals("read_input_float_register(3)", floats.memory().inScript(3));
    assertEquals("flag-3", flags.memory().id(3));
  }
}
