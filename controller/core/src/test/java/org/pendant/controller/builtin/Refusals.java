package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.function.Executable;
import org.pendant.script.value.ScriptError;

/** What a refused call must say. */
final class Refusals {
  private Refusals() {}

  static void refuses(String code, String part, Executable call) {
    ScriptError error = assertThrows(ScriptError.class, call);
    assertEquals(code, error.code(), error.getMessage());
    assertTrue(error.getMessage().contains(part), error.getMessage());
  }
}
