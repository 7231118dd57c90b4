package org.pendant.client;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Assumptions;
import org.pendant.command.Launcher;

/** Python with the published clients, in an environment below {@code src/test/target}. */
record PythonClients() implements ClientLanguage {
  private static final Path ENVIRONMENT = Launcher.home().resolve("src/test/target/python");
  private static final Path REQUIREMENTS = FOLDER.resolve("requirements.txt");

  @Override
  public List<Path> programs() {
    return ClientLanguage.programs(".py");
  }

  @Override
  public void prepare() {
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

  @Override
  public ProcessBuilder process(Path program, String host) {
    return new ProcessBuilder(python(), "-u", program.toString(), host);
  }
}
