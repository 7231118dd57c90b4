package org.pendant.recording.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

/** What a line asks of a move. */
final class MoveCallTest {
  private static MoveCall of(String line) {
    return MoveCall.of(
            line, name -> name.equals("FAST") ? OptionalDouble.of(0.5) : OptionalDouble.empty())
        .orElseThrow();
  }

  @Test
  void namesAndPlacesOfArgumentsAreRead() {
    assertEquals(OptionalDouble.of(0.5), of("movel(p[0, 1, 2, 0, 0, 0], a=1, v=FAST)").speed());
    assertEquals(OptionalDouble.of(2), of("  movej(f(1, [2, 3]), 3, 2)").speed());
    assertEquals(OptionalDouble.of(3), of("movej(f(1, [2, 3]), 3, 2)").acceleration());
  }

  @Test
  void whatIsNotSaidIsStandard() {
    assertEquals(OptionalDouble.of(0.25), of("movel(there)").speed());
    assertEquals(OptionalDouble.of(1.4), of("movej(there)").acceleration());
  }

  @Test
  void aTimeOrAnExpressionLeavesItOpen() {
    assertEquals(OptionalDouble.empty(), of("movej(there, t=2)").speed());
    assertEquals(OptionalDouble.empty(), of("movel(there, v=2*k)").speed());
  }

  @Test
  void otherLinesAreNone() {
    assertEquals(Optional.empty(), MoveCall.of("sleep(1)", name -> OptionalDouble.empty()));
  }
}
