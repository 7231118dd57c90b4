package org.pendant.gui.ports;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;

/** Finds an offset at which nobody uses the ports of a control box. */
final class FreePorts {
  private static final List<Integer> STANDARD =
      List.of(
          30_001, 30_002, 30_003, 30_004, 30_011, 30_012, 30_013, 29_999, 30_020, 502, 44_818,
          40_000, 54_321);

  private static final Random RANDOM = new Random();

  private FreePorts() {}

  /** What opens all ports of this computer's loopback address at such an offset. */
  static PortWishes wishes(Path programs) {
    int offset = 1000 + RANDOM.nextInt(PortWishes.LARGEST_OFFSET - 1000);
    while (!free(offset)) {
      offset = 1000 + RANDOM.nextInt(PortWishes.LARGEST_OFFSET - 1000);
    }
    return new PortWishes("127.0.0.1", offset, OptionalInt.empty(), programs, true);
  }

  private static boolean free(int offset) {
    List<ServerSocket> held = new ArrayList<>();
    try {
      for (int each : STANDARD) {
        held.add(new ServerSocket(each + offset, 1, InetAddress.getLoopbackAddress()));
      }
      return true;
    } catch (IOException e) {
      return false;
    } finally {
      for (ServerSocket each : held) {
        close(each);
      }
    }
  }

  private static void close(ServerSocket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      throw new AssertionError("a socket that nobody uses can be closed", e);
    }
  }
}
