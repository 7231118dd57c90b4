package org.pendant.client;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Assumptions;

/**
 * Python environment: Python with the packages of a list.
 *
 * @param folder where it is
 * @param requirements the list, as pip takes it
 */
record PythonEnvironment(Path folder, Path requirements) {
  /** Makes it ready; skips the test where that cannot be. */
  void prepare() {
    Path done = folder.resolve("requirements.txt");
    try {
      if (Files.exists(done) && Files.readString(done).equals(Files.readString(requirements))) {
        return;
      }
      Assumptions.assumeTrue(
          succeeds(List.of("python3", "-c", "import ensurepip, venv")),
          "skipped: Python 3 with venv is missing (Debian: apt install python3-venv)");
      install("python3", "-m", "venv", "--clear", folder.toString());
      install(
          python(),
          "-m",
          "pip",
          "install",
          "--quiet",
          "--disable-pip-version-check",
          "--requirement",
          requirements.toString());
      Files.copy(requirements, done);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static boolean succeeds(List<String> command) {
    try (Talker process = Talker.start(new ProcessBuilder(command))) {
      return process.awaitEnd(ClientLanguage.INSTALLING_S).equals(OptionalInt.of(0));
    } catch (UncheckedIOException e) {
      // there is no such program
      return false;
    }
  }

  private static void install(String... command) {
    try (Talker process = Talker.start(new ProcessBuilder(command))) {
      OptionalInt exit = process.awaitEnd(ClientLanguage.INSTALLING_S);
      if (!exit.equals(OptionalInt.of(0))) {
        fail("installing the clients: " + String.join(" ", command) + "\n" + process.said());
      }
    }
  }

  /** The interpreter. */
  String python() {
    return folder.resolve("bin/python").toString();
  }
}
