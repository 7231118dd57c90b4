package org.pendant.command.service;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

final class StateFolderTest {

  private static Path of(String system, Map<String, String> environment) {
    return StateFolder.of(system, "/home/maria", environment);
  }

  @Test
  void itIsWhereTheSystemHasWhatProgramsLeaveBehind() {
    assertEquals(Path.of("/home/maria/.local/state/pendant"), of("Linux", Map.of()));
    assertEquals(
        Path.of("/var/maria/pendant"), of("Linux", Map.of("XDG_STATE_HOME", "/var/maria")));
    assertEquals(Path.of("/home/maria/Library/Logs/Pendant"), of("Mac OS X", Map.of()));
    assertEquals(Path.of("/local/Pendant"), of("Windows 11", Map.of("LOCALAPPDATA", "/local")));
    assertEquals(Path.of("/home/maria/AppData/Local/Pendant"), of("Windows 11", Map.of()));
  }
}
