package org.pendant.command.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class RelaunchTest {
  private static final Path JAVA = Path.of("runtime");

  private static Optional<List<String>> command(Map<String, String> environment, String... words) {
    return new Relaunch("command", "Windows 11", environment)
        .command(List.of(words), JAVA, "app/pendant.jar");
  }

  @Test
  void whatHasTheOptionsOfTheLauncherStays() {
    assertEquals(Optional.empty(), command(Map.of(), "run", "a.script"));
  }

  @Test
  void whatHasOthersGetsAJvmWithThem() {
    List<String> command = command(Map.of(), "lsp", "--stdio").orElseThrow();

    assertEquals(JAVA.resolve("bin").resolve("java").toString(), command.getFirst());
    assertTrue(
        command.containsAll(StartKind.LANGUAGE_SERVER.all(List.of(), "Windows 11")),
        command.toString());
    assertEquals(
        List.of("-cp", "app/pendant.jar", "org.pendant.command.Pendant", "lsp", "--stdio"),
        command.subList(command.size() - 5, command.size()));
    assertTrue(command.stream().noneMatch(each -> each.contains(Relaunch.STARTED_AS)));
  }

  @Test
  void aWindowOnMacOsStaysInTheProcessThatTheDockKnows() {
    Relaunch mac = new Relaunch("command", "Mac OS X", Map.of());

    assertEquals(Optional.empty(), mac.command(List.of(), JAVA, "app/pendant.jar"));
    assertTrue(command(Map.of()).isPresent(), "from the console of Windows it does not");
  }

  @Test
  void optionsOfTheUserReachAJvmAsWell() {
    List<String> command =
        command(Map.of("PENDANT_JAVA_OPTIONS", " -Xmx1g  -Dmine=1 "), "run", "a.script")
            .orElseThrow();

    assertTrue(command.containsAll(List.of("-Xmx1g", "-Dmine=1")), command.toString());
  }
}
