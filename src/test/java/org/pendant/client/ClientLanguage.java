package org.pendant.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.pendant.command.Launcher;

/** A language of programs in {@link #FOLDER}, with the published clients that they use. */
sealed interface ClientLanguage permits PythonClients, NodeClients, RustClients {
  /** Where the programs are. */
  Path FOLDER = Launcher.home().resolve("src/test/clients");

  /** How long fetching and building clients may take. */
  int INSTALLING_S = 600;

  /** How long a program may take. */
  int PROGRAM_S = 300;

  /** The language's programs. */
  List<Path> programs();

  /** Makes the clients ready below {@code src/test/target}; skips the test where that cannot be. */
  void prepare();

  /** What runs {@code program}, which takes the address of a box as its argument. */
  ProcessBuilder process(Path program, String host);

  /** All programs whose names end with {@code end}. */
  static List<Path> programs(String end) {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files.filter(file -> file.toString().endsWith(end)).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Skips the test where there is no such program. */
  static void need(String program, String advice) {
    boolean there =
        Arrays.stream(System.getenv().getOrDefault("PATH", "").split(":"))
            .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
    Assumptions.assumeTrue(there, "skipped: " + program + " is missing (" + advice + ")");
  }

  /** Runs a program of {@link #FOLDER} against a box and expects that it finds all right. */
  default void run(Path program, Path folder, Served box) {
    ProcessBuilder builder = process(program, box.host()).directory(folder.toFile());
    builder.environment().put("PENDANT_HOME", Launcher.home().toString());
    try (Talker process = Talker.start(builder)) {
      OptionalInt exit = process.awaitEnd(PROGRAM_S);
      String story =
          program.getFileName()
              + " said:\n"
              + process.said()
              + "\npendant serve said:\n"
              + box.said();
      if (exit.isEmpty()) {
        fail("still running after " + PROGRAM_S + " s. " + story);
      }
      assertEquals(0, exit.getAsInt(), story);
    }
  }
}
