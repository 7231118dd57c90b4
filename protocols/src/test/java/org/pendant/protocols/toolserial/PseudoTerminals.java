package org.pendant.protocols.toolserial;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/** Two serial devices with a cable between them, by socat. */
final class PseudoTerminals implements AutoCloseable {
  private final Path box;
  private final Process socat;
  private final RandomAccessFile tool;

  private PseudoTerminals(Path box, Process socat, RandomAccessFile tool) {
    this.box = box;
    this.socat = socat;
    this.tool = tool;
  }

  /** Makes them in {@code folder}; skips the test where there is no socat. */
  static PseudoTerminals in(Path folder) throws IOException, InterruptedException {
    Assumptions.assumeTrue(present(), "skipped: socat is missing (Debian: apt install socat)");
    Path box = folder.resolve("box");
    Path tool = folder.resolve("tool");
    // -d -d: it says on standard error when each is there, and then that it has begun
    Process socat =
        new ProcessBuilder(
                "socat", "-d", "-d", "pty,raw,echo=0,link=" + box, "pty,raw,echo=0,link=" + tool)
            .start();
    var said = socat.errorReader();
    for (String line = said.readLine(); line != null; line = said.readLine()) {
      if (line.contains("starting data transfer")) {
        return new PseudoTerminals(box, socat, new RandomAccessFile(tool.toFile(), "rw"));
      }
    }
    throw new IOException("socat has ended with " + socat.waitFor());
  }

  private static boolean present() {
    for (String folder : System.getenv().getOrDefault("PATH", "").split(":", -1)) {
      if (Files.isExecutable(Path.of(folder, "socat"))) {
        return true;
      }
    }
    return false;
  }

  /** The device for the box. */
  String box() {
    return box.toString();
  }

  /** The tool reads so many bytes. */
  byte[] heard(int count) throws IOException {
    byte[] bytes = new byte[count];
    tool.readFully(bytes);
    return bytes;
  }

  /** The tool sends something. */
  void say(byte... bytes) throws IOException {
    tool.write(bytes);
  }

  /** Both devices go. */
  @Override
  public void close() throws IOException {
    tool.close();
    socat.destroy();
    try {
      socat.waitFor(10, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
