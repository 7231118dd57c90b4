package org.pendant.client;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Assumptions;
import org.pendant.command.Launcher;

/** Node with the published clients of {@code package.json}. */
record NodeClients() implements ClientLanguage {
  private static final Path MODULES = Launcher.home().resolve("src/test/target/node");
  private static final String PACKAGES = "package.json";

  @Override
  public List<Path> programs() {
    return ClientLanguage.programs(".cjs");
  }

  @Override
  public void prepare() {
    ClientLanguage.need("node", "Debian: apt install nodejs");
    ClientLanguage.need("npm", "Debian: apt install npm");
    Path done = MODULES.resolve("done.json");
    try {
      byte[] packages = Files.readAllBytes(FOLDER.resolve(PACKAGES));
      if (Files.exists(done) && Files.mismatch(done, FOLDER.resolve(PACKAGES)) < 0) {
        return;
      }
      Files.createDirectories(MODULES);
      Files.write(MODULES.resolve(PACKAGES), packages);
      try (Talker process = Talker.start(installing())) {
        Assumptions.assumeTrue(
            process.awaitEnd(INSTALLING_S).equals(OptionalInt.of(0)),
            () -> "skipped: the clients for Node cannot be fetched: " + process.said());
      }
      Files.copy(MODULES.resolve(PACKAGES), done, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Native parts, such as those for serial lines, are left out: no program here uses them. */
  private static ProcessBuilder installing() {
    return new ProcessBuilder(
            "npm",
            "install",
            "--no-package-lock",
            "--no-audit",
            "--no-fund",
            "--ignore-scripts",
            "--omit=optional")
        .directory(MODULES.toFile());
  }

  @Override
  public ProcessBuilder process(Path program, String host) {
    ProcessBuilder builder = new ProcessBuilder("node", program.toString(), host);
    builder.environment().put("NODE_PATH", MODULES.resolve("node_modules").toString());
    return builder;
  }
}
