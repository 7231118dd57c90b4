package org.pendant.script.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

final class HitRuleTest {
  private static List<Long> hits(String text) {
    HitRule rule = HitRule.of(text).orElseThrow();
    assertEquals(Optional.of(rule), HitRule.of(rule.text()));
    return LongStream.rangeClosed(1, 7).filter(rule::counts).boxed().toList();
  }

  @Test
  void theFormsOfEditorsAreRead() {
    assertEquals(List.of(5L, 6L, 7L), hits("5"));
    assertEquals(List.of(5L, 6L, 7L), hits(">=5"));
    assertEquals(List.of(6L, 7L), hits("> 5"));
    assertEquals(List.of(5L), hits("== 5"));
    assertEquals(List.of(5L), hits("=5"));
    assertEquals(List.of(1L, 2L), hits("<= 2"));
    assertEquals(List.of(1L), hits("< 2"));
    assertEquals(List.of(3L, 6L), hits(" %3 "));
    assertTrue(HitRule.of(" ").orElseThrow().always());
  }

  @Test
  void anythingElseIsNoRule() {
    for (String text : List.of("0", "< 1", "-1", "5 6", "% 0", "every 2", "!= 3", "9999999999")) {
      assertEquals(Optional.empty(), HitRule.of(text), text);
    }
  }
}
