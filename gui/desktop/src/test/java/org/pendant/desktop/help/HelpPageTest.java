package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.api.Test;

final class HelpPageTest {
  @Test
  void everyPageThatTheWindowDoesNotMakeItselfIsPackagedWithTheProgram() {
    for (HelpPage each : HelpPage.all()) {
      if (!each.equals(HelpPage.KEYS) && !each.equals(HelpPage.ABOUT)) {
        assertFalse(Markdown.html(HelpTexts.read(each.name())).isEmpty(), each.title());
      }
    }
  }

  @Test
  void screensHaveTheirPage() {
    assertEquals("Programs of nodes", HelpPage.of("program").title());
    assertEquals("Installations", HelpPage.of("installation").title());
    assertEquals(HelpPage.FIRST, HelpPage.of("log"));
  }

  @Test
  void linksAreReadFromWhereThePageIs() {
    HelpPage ports = new HelpPage("docs/protocols/README.md", "Ports");
    assertEquals("docs/protocols/rtde.md", ports.target("rtde.md"));
    assertEquals("docs/safety.md", ports.target("../safety.md#codes"));
    assertEquals("docs/protocols/README.md", ports.target("#ports"));
  }
}
