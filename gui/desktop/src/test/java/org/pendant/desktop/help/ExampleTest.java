package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

final class ExampleTest {
  private static final Path FOLDER = Path.of("..", "..", "examples");

  @Test
  void everyFileOfTheFolderIsAnExampleOrItsCompanion() throws IOException {
    try (Stream<Path> files = Files.walk(FOLDER)) {
      List<String> there =
          files
              .filter(Files::isRegularFile)
              .map(each -> FOLDER.relativize(each).toString().replace('\\', '/'))
              .filter(each -> !each.startsWith("tests/") && !each.startsWith("sweeps/"))
              .sorted()
              .toList();
      List<String> listed =
          Example.all().stream()
              .flatMap(each -> Stream.concat(Stream.of(each.file()), each.companions().stream()))
              .sorted()
              .toList();
      assertEquals(there, listed);
    }
  }

  @Test
  void meshesOfAnExampleAreUnpackedWhereItsSceneNamesThem() throws IOException {
    Example example =
        Example.all().stream()
            .filter(each -> each.file().equals("lift_casting.script"))
            .findFirst()
            .orElseThrow();
    Path folder = example.meshes().unpack();
    assertEquals(
        -1,
        Files.mismatch(FOLDER.resolve("parts/casting.stl"), folder.resolve("parts/casting.stl")));
  }

  @Test
  void everyExampleIsPackagedWithTheProgram() {
    for (Example each : Example.all()) {
      assertFalse(each.text().isEmpty(), each.file());
      each.companions().forEach(name -> assertFalse(Example.companion(name).isEmpty(), name));
    }
  }

  @Test
  void actionsAreCalledByTheNameInWords() {
    Example first = Example.all().getFirst();
    assertEquals("Example: pick and place", first.title());
    assertEquals("example.motion.pick-and-place", first.id());
  }
}
