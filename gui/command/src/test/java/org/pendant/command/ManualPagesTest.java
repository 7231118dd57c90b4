package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.SequencedMap;
import org.junit.jupiter.api.Test;
import org.pendant.text.Texts;

final class ManualPagesTest {
  private static final Instant DATE = Instant.parse("2026-01-02T23:30:00Z");

  private static List<Subcommand> subcommands() {
    return new Pendant(new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream()))
        .subcommands();
  }

  private static SequencedMap<String, String> pages() {
    return new ManualPages(subcommands(), DATE).all();
  }

  @Test
  void thereIsAPageForEachCommandAndOneThatNamesThemAll() {
    List<String> expected = new ArrayList<>(List.of("pendant.1"));
    subcommands().forEach(each -> expected.add("pendant-" + each.name() + ".1"));
    assertEquals(expected, List.copyOf(pages().sequencedKeySet()));
    String overview = pages().get("pendant.1");
    for (Subcommand each : subcommands()) {
      assertTrue(overview.contains(".BR pendant\\-" + each.name() + " (1)\n"), each.name());
    }
    assertTrue(overview.startsWith(".TH PENDANT 1 2026-01-02 "), overview);
  }

  @Test
  void aPageHasEveryOptionWithItsExplanation() {
    Texts usage = UsageTexts.english();
    for (Subcommand each : subcommands()) {
      String page = pages().get("pendant-" + each.name() + ".1").replace("\\-", "-");
      List<Option> options = new ArrayList<>(each.options());
      options.add(Subcommand.HELP);
      for (Option option : options) {
        String value = option.takesValue() ? " \\fI" + option.value() + "\\fR" : "";
        String entry = "\n.TP\n\\fB" + option.name() + "\\fR" + value + "\n";
        assertTrue(
            page.contains(entry + option.description(usage) + "\n"), each.name() + option.name());
      }
    }
  }

  @Test
  void noTextIsTakenForARequestOrAnEscapeOfTroff() {
    assertEquals("\\-\\-odd A\\eB", ManualPages.text("--odd A\\B"));
    assertEquals("\\&.br of 'it'", ManualPages.text(".br of 'it'"));
    assertEquals("\\&'it'", ManualPages.text("'it'"));
  }
}
