package org.pendant.kit.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

final class ConfigurationFolderTest {

  private static Path of(String system, Map<String, String> environment) {
    return ConfigurationFolder.of(
        Map.of("os.name", system, "user.home", "/home/maria"), environment);
  }

  @Test
  void itIsWhereTheSystemHasSettings() {
    assertEquals(Path.of("/home/maria/.config/pendant"), of("Linux", Map.of()));
    assertEquals(
        Path.of("/etc/maria/pendant"), of("Linux", Map.of("XDG_CONFIG_HOME", "/etc/maria")));
    assertEquals(
        Path.of("/home/maria/Library/Application Support/Pendant"), of("Mac OS X", Map.of()));
    assertEquals(Path.of("/roaming/Pendant"), of("Windows 11", Map.of("APPDATA", "/roaming")));
  }

  @Test
  void propertyNamesAnotherOne() {
    assertEquals(
        Path.of("/trial"),
        ConfigurationFolder.of(Map.of(ConfigurationFolder.PROPERTY, "/trial"), Map.of()));
  }
}
