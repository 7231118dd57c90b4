package org.pendant.protocols.server;

import java.net.InetAddress;
import java.util.HashMap;
import java.util.Map;
import org.pendant.protocols.net.Listening;

/**
 * Port numbers: where the servers of one controller listen.
 *
 * @param host address of the interface
 * @param offset is added to every standard port number
 * @param free any free port instead of the standard ones, for tests
 * @param chosen ports that differ from the rule, by their standard numbers
 */
public record PortNumbers(
    InetAddress host, int offset, boolean free, Map<Integer, Integer> chosen) {
  /** Copies the map. */
  public PortNumbers {
    chosen = Map.copyOf(chosen);
  }

  /** Without exceptions. */
  public PortNumbers(InetAddress host, int offset, boolean free) {
    this(host, offset, free, Map.of());
  }

  /** Free ports of the loopback interface. */
  public static PortNumbers anyFree() {
    return new PortNumbers(InetAddress.getLoopbackAddress(), 0, true);
  }

  /** The same ports of another interface. */
  public PortNumbers at(InetAddress other) {
    return new PortNumbers(other, offset, free, chosen);
  }

  /** With another number for what stands at {@code standardPort} on a real box. */
  public PortNumbers with(int standardPort, int number) {
    Map<Integer, Integer> more = new HashMap<>(chosen);
    more.put(standardPort, number);
    return new PortNumbers(host, offset, free, more);
  }

  /** Where the protocol {@code name} listens that stands at {@code standardPort} on a real box. */
  public Listening listening(String name, int standardPort) {
    int number = free ? 0 : standardPort + offset;
    return new Listening(name, host, chosen.getOrDefault(standardPort, number));
  }
}
