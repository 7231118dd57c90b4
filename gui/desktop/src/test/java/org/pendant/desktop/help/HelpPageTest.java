package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
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
  void linksToPlacesOfPagesLeadToHeadings() {
    Pattern link = Pattern.compile("href=\"([^\":]*)#([^\"]+)\"");
    int links = 0;
    for (HelpPage each : HelpPage.all()) {
      Matcher found = link.matcher(HelpTexts.find(each.name()).map(Markdown::html).orElse(""));
      while (found.find()) {
        String target = Markdown.html(HelpTexts.read(each.target(found.group(1))));
        assertTrue(target.contains("id=\"" + found.group(2) + "\""), each + ": " + found.group());
        links++;
      }
    }
    assertTrue(links > 20, links + " links");
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
