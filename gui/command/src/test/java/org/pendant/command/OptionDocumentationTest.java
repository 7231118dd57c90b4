package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.pendant.text.Texts;

/** docs/command-line.md against the options that the commands declare. */
final class OptionDocumentationTest {
  /** Those whose options the page has in tables; what one of them has, the next only mentions. */
  private static final List<String> TABLES =
      List.of("run", "serve", "render", "open", "record", "compare", "test", "sweep", "doctor");

  private static final Texts USAGE = UsageTexts.english();

  private static List<Subcommand> subcommands() {
    return new Pendant(new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream()))
        .subcommands();
  }

  private static Subcommand subcommand(String name) {
    return subcommands().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private static String section(String name) throws IOException {
    String page = Files.readString(Path.of("../../docs/command-line.md"));
    Matcher section =
        Pattern.compile("^## " + name + "\n(.*?)(?=^## |\\z)", Pattern.DOTALL | Pattern.MULTILINE)
            .matcher(page);
    assertTrue(section.find(), name);
    return section.group(1);
  }

  private static String row(Option option) {
    return "| " + String.join(" | ", option.row(USAGE)) + " |";
  }

  @Test
  void tablesHaveTheRowsOfTheOptions() throws IOException {
    Set<String> seen = new HashSet<>();
    for (String name : TABLES) {
      List<String> expected = new ArrayList<>();
      for (Option option : subcommand(name).options()) {
        if (seen.add(option.name())) {
          expected.add(row(option));
        }
      }
      List<String> found = section(name).lines().filter(line -> line.startsWith("| `--")).toList();
      assertEquals(String.join("\n", expected), String.join("\n", found), name);
    }
  }

  @Test
  void everyOptionIsMentionedWhereItsCommandIsExplained() throws IOException {
    for (Subcommand each : subcommands()) {
      String section = section(each.name());
      for (Option option : each.options()) {
        assertTrue(section.contains("`" + option.name()), each.name() + " " + option.name());
      }
    }
  }

  @Test
  void whatCountsWithoutAnOptionIsInItsRow() {
    for (Subcommand each : subcommands()) {
      for (Option option : each.options()) {
        String row = row(option);
        assertTrue(row.contains(option.standard()), row);
      }
    }
  }
}
