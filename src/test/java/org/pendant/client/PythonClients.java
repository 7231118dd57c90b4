package org.pendant.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Assumptions;
import org.pendant.command.Launcher;

/** Python with the published clients, in an environment below {@code src/test/target}. */
final class PythonClients {
  /** Where the programs are. */
  static final Path FOLDER = Launcher.home().resolve("src/test/clients");

  private static final Path ENVIRONMENT = Launcher.home().resolve("src/test/target/python");
  private static final Path REQUIREMENTS = FOLDER.resolve("requirements.txt");
  private static final int INSTALLING_S = 600;
  private static final int PROGRAM_S = 300;

  private PythonClients() {}

  /** Makes the environment unless it is there; skips the test where there is no Python 3. */
  static void prepare() {
    Path done = ENVIRONMENT.resolve("requirements.txt");
    try {
      if (Files.exists(done) && Files.readString(done).equals(Files.readString(REQUIREMENTS))) {
        return;
      }
      Assumptions.assumeTrue(
          succeeds(List.of("python3", "-c", "import ensurepip, venv")),
          "skipped: Python 3 with venv is missing (Debian: apt install python3-venv)");
      install("python3", "-m", "venv", "--clear", ENVIRONMENT.toString());
      install(
          python(),
          "-m",
          "pip",
          "install",
          "--quiet",
          "--disable-pip-version-check",
          "--requirement",
          REQUIREMENTS.toString());
      Files.copy(REQUIREMENTS, done);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static boolean succeeds(List<String> command) {
    try (Talker process = Talker.start(new ProcessBuilder(command))) {
      return process.awaitEnd(INSTALLING_S).equals(OptionalInt.of(0));
    } catch (UncheckedIOException e) {
      // there is no such program
      return false;
    }
  }

  private static void install(String... command) {
    try (Talker process = Talker.start(new ProcessBuilder(command))) {
      OptionalInt exit = process.awaitEnd(INSTALLING_S);
      if (!exit.equals(OptionalInt.of(0))) {
        fail("installing the clients: " + String.join(" ", command) + "\n" + process.said());
      }
    }
  }

  private static String python() {
    return ENVIRONMENT.resolve("bin/python").toString();
  }

  /** Runs a program of {@link #FOLDER} against a box and expects that it finds all right. */
  static void run(Path program, Path folder, Served box) {
    List<String> command = new ArrayList<>(List.of(python(), "-u", program.toString(), box.host()));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
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
