package org.pendant.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher;

/** Every program of {@code src/test/clients} against a box of its own. */
class RealClientsTest {
  /** The options of a program's box stand behind this. */
  private static final String SERVE = "# serve:";

  @TempDir Path folder;

  @TestFactory
  @Timeout(value = 25, unit = TimeUnit.MINUTES) // the first time, it installs Python packages
  Stream<DynamicTest> publishedClientsGetWhatTheyAskFor() throws IOException {
    PythonClients.prepare();
    List<Path> programs;
    try (Stream<Path> files = Files.list(PythonClients.FOLDER)) {
      programs = files.filter(file -> file.toString().endsWith(".py")).sorted().toList();
    }
    return IntStream.range(0, programs.size())
        .mapToObj(
            i ->
                dynamicTest(
                    programs.get(i).getFileName().toString(), () -> run(i + 1, programs.get(i))));
  }

  private void run(int number, Path program) throws IOException {
    Path own = Files.createDirectory(folder.resolve("box" + number));
    try (Served box = Served.start(number, own, options(program, own))) {
      PythonClients.run(program, own, box);
      assertEquals(0, box.stop(), box.said());
    }
  }

  private static List<String> options(Path program, Path own) throws IOException {
    String words =
        Files.readAllLines(program).stream()
            .filter(line -> line.startsWith(SERVE))
            .findFirst()
            .map(line -> line.substring(SERVE.length()).strip())
            .orElse("--ready");
    return Stream.of(words.split(" +"))
        .map(word -> word.replace("{home}", Launcher.home().toString()))
        .map(word -> word.replace("{folder}", own.toString()))
        .toList();
  }
}
