package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;

final class SignalLabelsTest {
  private final Map<String, String> settings = new HashMap<>();
  private final Map<String, String> installed = new HashMap<>();
  private final SignalLabels labels =
      SignalLabels.installed(
          new MemorySettings(settings),
          signal -> installed.getOrDefault(signal, ""),
          installed::put);

  @Test
  void theInstallationHasTheWord() {
    settings.put("io.label.digital-in-0", "Old");
    assertEquals("Old", labels.of("digital-in-0"));
    installed.put("digital_in[0]", "Part");
    assertEquals("Part", labels.of("digital-in-0"));
  }

  @Test
  void namesGoIntoTheInstallation() {
    settings.put("io.label.input-float-register-3", "Old");
    labels.name("input-float-register-3", " Force ");
    assertEquals(Map.of("input_float_register[3]", "Force"), installed);
    installed.clear();
    assertEquals("", labels.of("input-float-register-3"));
  }

  @Test
  void whatHasNoNumberHasNoName() {
    assertEquals("", labels.of("timestamp"));
  }
}
