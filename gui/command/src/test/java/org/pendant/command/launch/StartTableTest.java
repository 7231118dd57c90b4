package org.pendant.command.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What launchers read is what {@link StartKind} declares. */
final class StartTableTest {
  private static final String OPTION = "--java-options ";

  /** The project's folder, above the module's, which tests run in, or that folder itself. */
  private static Path home() {
    Path here = Path.of("").toAbsolutePath();
    return Stream.iterate(here, Path::getParent)
        .filter(each -> Files.exists(each.resolve(".build")))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theShellReadsThem() throws IOException {
    assertEquals(
        String.join("\n", StartTable.lines()),
        String.join("\n", Files.readAllLines(home().resolve(".build/options.sh"))),
        "StartTable prints what .build/options.sh should be");
  }

  @Test
  void theCommandOfJpackageHasThoseOfCommands() throws IOException {
    List<String> options =
        Files.readAllLines(home().resolve(".build/packages/jpackage.options")).stream()
            .filter(each -> each.startsWith(OPTION))
            .map(each -> each.substring(OPTION.length()))
            .toList();

    assertEquals(asJpackageHasThem(StartKind.COMMAND), options);
  }

  @Test
  void theWindowOfJpackageOnWindowsHasThoseOfWindows() throws IOException {
    String line =
        Files.readAllLines(home().resolve(".build/packages/pendantw.properties")).stream()
            .filter(each -> each.startsWith("java-options="))
            .findFirst()
            .orElseThrow();

    assertEquals(
        String.join(" ", asJpackageHasThem(StartKind.WINDOW)),
        line.substring("java-options=".length()));
  }

  private static List<String> asJpackageHasThem(StartKind kind) {
    List<String> all = new ArrayList<>(kind.all(List.of(), "Windows 11"));
    all.add("-D" + Relaunch.STARTED_AS + "=" + kind.word());
    return all;
  }

  @Test
  void noOptionNeedsQuoting() {
    for (StartKind each : StartKind.values()) {
      assertFalse(
          each.all(List.of(), "Linux").stream().anyMatch(o -> o.matches(".*[\\s'\"$].*")),
          each.word());
      assertTrue(each.cache().matches("[a-z]+"));
    }
  }
}
