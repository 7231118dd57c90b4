package org.pendant.client;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher;

/** The tests of the Python package, and the examples of docs/python.md. */
@Tag("slow")
class PythonPackageTest {
  private static final Path HOME = Launcher.home().resolve("protocols/python");
  private static final int PATIENCE_S = 300;

  @TempDir Path folder;

  @Test
  @Timeout(value = 15, unit = TimeUnit.MINUTES) // the first time, it fetches pytest
  void testsOfThePythonPackageAreGreen() {
    PythonEnvironment environment =
        new PythonEnvironment(
            Launcher.home().resolve("src/test/target/python-package"),
            HOME.resolve("tests/requirements.txt"));
    environment.prepare();
    ProcessBuilder launcher = Launcher.prepare(folder, "rpc");
    ProcessBuilder builder =
        new ProcessBuilder(
                environment.python(),
                "-m",
                "pytest",
                "-q",
                "-p",
                "no:cacheprovider",
                "-p",
                "pendant.pytest_plugin",
                "--basetemp",
                folder.resolve("pytest").toString(),
                HOME.resolve("tests").toString())
            .directory(folder.toFile());
    builder.environment().putAll(launcher.environment());
    builder.environment().put("PYTHONPATH", HOME.resolve("src").toString());
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    // the package is not installed here, or by somebody else in his own way
    builder.environment().put("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1");
    try (Talker pytest = Talker.start(builder)) {
      OptionalInt exit = pytest.awaitEnd(PATIENCE_S);
      assertEquals(OptionalInt.of(0), exit, pytest::said);
    }
  }
}
