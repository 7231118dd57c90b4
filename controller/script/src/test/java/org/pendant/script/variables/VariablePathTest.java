package org.pendant.script.variables;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class VariablePathTest {

  @Test
  void thereIsOneWayToWriteEach() {
    assertEquals("count", VariablePath.of(" count ").text());
    assertEquals("p[2]", VariablePath.of("p [ 2 ]").text());
    assertEquals("m[0][1]", VariablePath.of("m[0, 1]").text());
    assertEquals("part.sizes[3].x", VariablePath.of("part . sizes[3] .x").text());
    assertEquals(VariablePath.of("m[0][1]"), VariablePath.of("m[ 0 ,1 ]"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "3",
        "p[",
        "p[]",
        "p[-1]",
        "p[i]",
        "p[1,2,3]",
        "a + b",
        "f()",
        "a.",
        "a b"
      })
  void anythingElseIsRefused(String text) {
    assertEquals(
        "'" + text.strip() + "' is no variable, expected such as count, p[2] or part.size",
        assertThrows(IllegalArgumentException.class, () -> VariablePath.of(text)).getMessage());
  }

  @Test
  void anIndexThatNoListHasIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> VariablePath.of("p[99999999999]"));
  }
}
