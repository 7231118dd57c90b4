package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;

/** A translation that fails does no harm, and is told of. */
class HotFunctionsTest {
  private final IllegalStateException fault = new IllegalStateException("no such tag");

  private final Program program = new MachineFixture().compile("def prog():", "  x = 1", "end");
  private final ScriptFunction function = program.tables().functions().getFirst();

  @Test
  void functionWhoseTranslationFailsIsInterpreted() {
    HotFunctions hot =
        new HotFunctions(
            Translation.ALWAYS,
            program.tables(),
            (function, tables) -> {
              throw fault;
            });
    assertFalse(hot.translated(function));
    assertEquals(Optional.of(fault), hot.takeFault());
    assertFalse(hot.translated(function));
    assertEquals(Optional.empty(), hot.takeFault(), "it is tried once, and told once");
  }

  @Test
  void functionThatCanBeTranslatedIs() {
    HotFunctions hot = new HotFunctions(Translation.ALWAYS, program.tables());
    assertTrue(hot.translated(function));
    assertEquals(Optional.empty(), hot.takeFault());
  }
}
