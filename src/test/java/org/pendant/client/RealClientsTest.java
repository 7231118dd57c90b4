package org.pendant.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher;

/** Every program of {@code src/test/clients} against a box of its own. */
@Tag("slow")
class RealClientsTest {
  /** The options of a program's box stand behind this. */
  private static final String SERVE = "# serve:";

  @TempDir Path folder;

  @TestFactory
  @Timeout(value = 25, unit = TimeUnit.MINUTES) // the first time, it fetches clients
  Stream<DynamicTest> publishedClientsGetWhatTheyAskFor() {
    List<DynamicTest> tests = new ArrayList<>();
    for (ClientLanguage language :
        List.of(new PythonClients(), new NodeClients(), new RustClients())) {
      for (Path program : language.programs()) {
        int number = tests.size() + 1;
        tests.add(
            dynamicTest(program.getFileName().toString(), () -> run(number, language, program)));
      }
    }
    return tests.stream();
  }

  private void run(int number, ClientLanguage language, Path program) throws IOException {
    language.prepare();
    Path own = Files.createDirectory(folder.resolve("box" + number));
    try (Served box = Served.start(number, own, options(program, own))) {
      language.run(program, own, box);
      assertEquals(0, box.stop(), box.said());
    }
  }

  private static List<String> options(Path program, Path own) throws IOException {
    String words =
        Files.readAllLines(program).stream()
            .filter(line -> line.contains(SERVE))
            .findFirst()
            .map(line -> line.substring(line.indexOf(SERVE) + SERVE.length()).strip())
            .orElse("--ready");
    return Stream.of(words.split(" +"))
        .map(word -> word.replace("{home}", Launcher.home().toString()))
        .map(word -> word.replace("{folder}", own.toString()))
        .toList();
  }
}
