package org.pendant.protocols.serve;

import java.net.InetAddress;
import org.pendant.protocols.net.Listening;

/**
 * Where the servers of one controller listen.
 *
 * @param host address of the interface
 * @param offset is added to every standard port number
 * @param free any free port instead of the standard ones, for tests
 */
public record PortNumbers(InetAddress host, int offset, boolean free) {
  /** Free ports of the loopback interface. */
  public static PortNumbers anyFree() {
    return new PortNumbers(InetAddress.getLoopbackAddress(), 0, true);
  }

  /** Where the protocol {@code name} listens that stands at {@code standardPort} on a real box. */
  public Listening listening(String name, int standardPort) {
    return new Listening(name, host, free ? 0 : standardPort + offset);
  }
}
