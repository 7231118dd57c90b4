package org.pendant.client;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Assumptions;
import org.pendant.command.Launcher;

/** {@code ./pendant serve} at an address of its own. */
public final class Served implements AutoCloseable {
  /** Far longer than it takes. */
  private static final int PATIENCE_S = 90;

  private final String host;
  private final Talker process;

  private Served(String host, Talker process) {
    this.host = host;
    this.process = process;
  }

  /**
   * Starts a box and waits until it is ready.
   *
   * @param number of the address, 1 to 250: another one for each box of the tests
   * @param folder where it works
   */
  public static Served start(int number, Path folder, List<String> options) {
    String host = host(number);
    List<String> words =
        new ArrayList<>(
            List.of("serve", "--host", host, "--logs", folder.resolve("logs").toString()));
    words.addAll(options);
    Talker process = Talker.start(Launcher.prepare(folder, words.toArray(String[]::new)));
    Served served = new Served(host, process);
    Optional<String> ready = process.awaitLine("ready"::equals, PATIENCE_S);
    if (ready.isEmpty()) {
      served.close();
      fail("pendant " + String.join(" ", words) + " did not get ready:\n" + process.said());
    }
    return served;
  }

  /**
   * A loopback address that no other process of tests uses at the same time: some clients know the
   * standard ports only.
   *
   * @param number of the address among those of this process, 1 to 250
   */
  public static String host(int number) {
    long process = ProcessHandle.current().pid();
    String host = "127.%d.%d.%d".formatted(100 + process / 250 % 100, process % 250, number);
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getByName(host))) {
      Assumptions.assumeTrue(probe.isBound());
    } catch (IOException e) {
      Assumptions.abort(
          "skipped: this system has only one loopback address, " + host + ": " + e.getMessage());
    }
    return host;
  }

  /** Where it listens. */
  public String host() {
    return host;
  }

  /** What it has written. */
  public String said() {
    return process.said();
  }

  /** The number of its process. */
  public long pid() {
    return process.pid();
  }

  /** Asks it to end as a system does, and answers its exit code. */
  public int stop() {
    process.terminate();
    return process
        .awaitEnd(PATIENCE_S)
        .orElseGet(() -> fail("still serving after SIGTERM:\n" + process.said()));
  }

  @Override
  public void close() {
    process.close();
  }
}
