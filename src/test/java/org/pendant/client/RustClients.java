package org.pendant.client;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Assumptions;
import org.pendant.command.Launcher;

/** The program of the crate {@code rust}, which Cargo builds. */
record RustClients() implements ClientLanguage {
  private static final Path CRATE = FOLDER.resolve("rust");
  private static final Path TARGET = Launcher.home().resolve("src/test/target/rust");

  @Override
  public List<Path> programs() {
    return List.of(CRATE.resolve("src/rust_rur.rs"));
  }

  @Override
  public void prepare() {
    ClientLanguage.need("cargo", "Debian: apt install cargo");
    ProcessBuilder building =
        new ProcessBuilder(
            "cargo",
            "build",
            "--quiet",
            "--locked",
            "--manifest-path",
            CRATE.resolve("Cargo.toml").toString(),
            "--target-dir",
            TARGET.toString());
    try (Talker process = Talker.start(building)) {
      boolean built = process.awaitEnd(INSTALLING_S).equals(OptionalInt.of(0));
      // what cannot be compiled is our mistake, what cannot be fetched is not
      Assumptions.assumeTrue(
          built || process.said().contains("could not compile"),
          () -> "skipped: the client for Rust cannot be fetched: " + process.said());
    }
  }

  @Override
  public ProcessBuilder process(Path program, String host) {
    return new ProcessBuilder(TARGET.resolve("debug/rust_rur").toString(), host);
  }
}
