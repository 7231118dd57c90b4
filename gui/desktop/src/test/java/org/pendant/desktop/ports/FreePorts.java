package org.pendant.desktop.ports;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.OptionalInt;
import org.junit.jupiter.api.Assumptions;
import org.pendant.command.service.PortWishes;

/** A place for the ports of a control box that no other process of tests uses. */
final class FreePorts {
  /** No port below 1024, which not everybody may open. */
  private static final int OFFSET = 2000;

  private FreePorts() {}

  /** What opens all ports at a loopback address of this process's own. */
  static PortWishes wishes(Path programs) {
    long process = ProcessHandle.current().pid();
    String host = "127.%d.%d.1".formatted(1 + process / 250 % 99, process % 250);
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getByName(host))) {
      Assumptions.assumeTrue(probe.isBound());
    } catch (IOException e) {
      Assumptions.abort(
          "skipped: this system has only one loopback address, " + host + ": " + e.getMessage());
    }
    return new PortWishes(host, OFFSET, OptionalInt.empty(), programs, true);
  }

  /** Where such wishes listen. */
  static InetAddress address(PortWishes wishes) {
    try {
      return InetAddress.getByName(wishes.host());
    } catch (UnknownHostException e) {
      throw new UncheckedIOException(e);
    }
  }
}
