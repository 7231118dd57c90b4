package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.project.program.NodeKind;

/** What kinds of nodes are called. */
final class KindTitlesTest {
  @Test
  void inEnglishKindsAreCalledAsInTheProject() {
    for (NodeKind each : NodeKind.values()) {
      assertEquals(each.title(), KindTitles.of(each));
    }
  }
}
