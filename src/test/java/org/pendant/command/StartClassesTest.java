package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A start makes no lambda that the AOT cache cannot hold: the serializable ones of {@code
 * Comparator.comparingInt} and the like, and of the comparator of a {@code TreeMap}'s stream. The
 * JVM would spin them each time.
 */
@Tag("slow")
final class StartClassesTest {
  @TempDir Path folder;

  @Test
  void runsOfSmallProgramsSpinNoSerializableLambda() throws IOException {
    Path examples = Launcher.home().resolve("examples");
    Launcher.Result result =
        Launcher.shell(
            folder,
            "PENDANT_JAVA_OPTIONS=-Xlog:class+load:file=classes.txt \"$PENDANT\" run"
                + " '%s' '%s'"
                    .formatted(
                        examples.resolve("hello.script"),
                        examples.resolve("shared_counter.script")));

    assertEquals(0, result.exitCode(), result.errors());
    List<String> loaded = Files.readAllLines(folder.resolve("classes.txt"));
    assertTrue(loaded.stream().anyMatch(line -> line.contains("org.pendant.command.HeadlessRun")));
    assertEquals(List.of(), loaded.stream().filter(StartClassesTest::serializable).toList());
  }

  private static boolean serializable(String line) {
    return line.matches(".* java\\.util\\.(Comparator|TreeMap).*Lambda.*");
  }
}
