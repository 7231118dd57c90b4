package org.pendant.fuzz;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The short run of the fuzzer; a failure says the seed and the text. */
@Tag("slow")
final class ScriptFuzzTest {
  private final ScriptFuzzer fuzzer = new ScriptFuzzer();

  @Test
  void everyTextIsReadOrRefusedWithReasonsThatLieInIt() {
    assertEquals(List.of(), fuzzer.read(0, 2_000));
  }

  @Test
  void everyProgramThatCompilesRunsOrFailsByItsOwnFault() {
    assertEquals(List.of(), fuzzer.run(0, 150));
  }
}
