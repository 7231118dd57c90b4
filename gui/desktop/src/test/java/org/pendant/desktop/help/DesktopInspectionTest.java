package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.pendant.command.doctor.Finding;
import org.pendant.command.doctor.Inspection;

final class DesktopInspectionTest {

  @Test
  void doctorFindsItAndItLooksAtWhatTheWindowNeeds() {
    Inspection inspection = ServiceLoader.load(Inspection.class).findFirst().orElseThrow();
    List<Finding> findings = inspection.findings();

    assertEquals(
        List.of("Settings", "Display", "Fonts", "OpenGL"),
        findings.stream().map(each -> each.subject().english()).toList());
    for (Finding each : findings) {
      assertTrue(
          each.level() == Finding.Level.OK
              ? each.advice().english().isEmpty()
              : !each.advice().english().isBlank(),
          each::toString);
    }
  }
}
