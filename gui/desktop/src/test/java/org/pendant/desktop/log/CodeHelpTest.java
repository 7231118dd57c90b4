package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.safety.StopReason;

final class CodeHelpTest {

  @Test
  void everyCodeOfTheSafetyFunctionsIsExplained() {
    for (StopReason each : StopReason.values()) {
      CodeHelp help = CodeHelp.of("C" + each.code() + "A0").orElseThrow();
      assertTrue(help.meaning().endsWith("."), each.name());
      assertTrue(help.suggestion().endsWith("."), each.name());
    }
  }

  @Test
  void theArgumentSaysWhichLimit() {
    assertEquals(
        "A safety limit was exceeded: tool speed.", CodeHelp.of("C191A2").orElseThrow().meaning());
  }

  @Test
  void otherCodesAreNotExplained() {
    assertEquals(Optional.empty(), CodeHelp.of("wrong-type"));
    assertEquals(Optional.empty(), CodeHelp.of("C99A1"));
    assertEquals(Optional.empty(), CodeHelp.of(""));
  }
}
