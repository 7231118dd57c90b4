package org.pendant.command.doctor;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Looks which ports of a control box are free on this computer, and who has the others. */
final class PortInspection implements Inspection {
  /** Below it systems may ask for more rights. */
  private static final int FIRST_FREE_FOR_ALL = 1024;

  private final List<StandardPort> ports;
  private final PortHolder holders;

  PortInspection(List<StandardPort> ports, PortHolder holders) {
    this.ports = List.copyOf(ports);
    this.holders = holders;
  }

  @Override
  public List<Finding> findings() {
    List<Finding> findings = new ArrayList<>();
    List<Integer> free = new ArrayList<>();
    for (StandardPort port : ports) {
      if (isFree(port)) {
        free.add(port.number());
      } else {
        findings.add(taken(port));
      }
    }
    if (!free.isEmpty()) {
      String numbers = String.join(" ", free.stream().distinct().map(String::valueOf).toList());
      findings.addFirst(Finding.ok("Ports", "free: " + numbers));
    }
    return findings;
  }

  private static boolean isFree(StandardPort port) {
    InetSocketAddress place =
        new InetSocketAddress(InetAddress.getLoopbackAddress(), port.number());
    if (port.udp()) {
      try (DatagramSocket socket = new DatagramSocket(place)) {
        return socket.isBound();
      } catch (IOException e) {
        return false;
      }
    }
    try (ServerSocket socket = new ServerSocket()) {
      socket.bind(place);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private Finding taken(StandardPort port) {
    Optional<String> holder = holders.of(port);
    if (holder.isEmpty() && port.number() < FIRST_FREE_FOR_ALL) {
      return Finding.note(
          "Port " + port.number(),
          port.protocol() + ": the system does not let you open it",
          "Pendant opens port %d instead; --modbus-port chooses another one"
              .formatted(port.number() + 1000));
    }
    if (holder.equals(Optional.of(PortHolder.SELF))) {
      return Finding.ok("Port " + port.number(), port.words() + ": opened by " + PortHolder.SELF);
    }
    return Finding.problem(
        "Port " + port.number(),
        "%s: taken by %s".formatted(port.words(), holder.orElse(holders.unknown(port))),
        "end that program, or let Pendant listen elsewhere: pendant serve --port-offset 100, or"
            + " --host 127.0.0.2");
  }
}
