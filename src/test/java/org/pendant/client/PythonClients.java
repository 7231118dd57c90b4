package org.pendant.client;

import java.nio.file.Path;
import java.util.List;
import org.pendant.command.Launcher;

/** Python with the published clients, in an environment below {@code src/test/target}. */
record PythonClients() implements ClientLanguage {
  private static final PythonEnvironment ENVIRONMENT =
      new PythonEnvironment(
          Launcher.home().resolve("src/test/target/python"), FOLDER.resolve("requirements.txt"));

  @Override
  public List<Path> programs() {
    return ClientLanguage.programs(".py");
  }

  @Override
  public void prepare() {
    ENVIRONMENT.prepare();
  }

  @Override
  public ProcessBuilder process(Path program, String host) {
    return new ProcessBuilder(ENVIRONMENT.python(), "-u", program.toString(), host);
  }
}
