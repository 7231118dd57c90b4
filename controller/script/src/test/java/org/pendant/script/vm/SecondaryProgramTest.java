package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Secondary programs (manual 12). */
class SecondaryProgramTest {
  private final MachineFixture fixture = new MachineFixture();

  @Test
  void itRunsWholeBesideThePrimaryProgram() {
    fixture.start("def prog():", "  frames(3)", "  textmsg(\"primary\")", "end").advance(1);
    Program secondary = fixture.compile("sec s():", "  textmsg(\"secondary\")", "end");
    assertTrue(secondary.secondary());
    assertEquals(Optional.empty(), fixture.machine.runSecondary(secondary));
    fixture.finish();
    assertEquals(List.of("secondary", "primary"), fixture.messages);
  }

  @Test
  void itsErrorLeavesThePrimaryRunning() {
    fixture.start("def prog():", "  frames(3)", "end").advance(1);
    ScriptFailure failure =
        fixture
            .machine
            .runSecondary(fixture.compile("sec s():", "  x = [1]", "  y = x[4]", "end"))
            .orElseThrow();
    assertEquals(3, failure.line());
    assertEquals(ProgramState.RUNNING, fixture.machine.state());
  }

  @Test
  void anEndlessOneIsStoppedWithinTheFrame() {
    ScriptFailure failure =
        fixture
            .machine
            .runSecondary(fixture.compile("sec s():", "  while True:", "    x = 1", "  end", "end"))
            .orElseThrow();
    assertEquals("runtime-too-much-behind", failure.code());
  }
}
