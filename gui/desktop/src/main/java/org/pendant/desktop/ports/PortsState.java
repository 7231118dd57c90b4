package org.pendant.desktop.ports;

import java.util.List;
import java.util.Optional;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.MissingPort;

/** Ports state: whether the ports are open. */
sealed interface PortsState {
  /** Nothing has been wrong. */
  Closed CLOSED = new Closed(Optional.empty());

  /**
   * Why they could not be opened.
   *
   * @param field where it can be put right
   */
  record Trouble(PortField field, String text) {}

  /** No server listens. */
  record Closed(Optional<Trouble> trouble) implements PortsState {}

  /**
   * A port.
   *
   * @param controller whose it is; empty where there is one alone
   * @param address of its interface, as people write it before a colon
   */
  record OpenPort(String controller, String address, TcpPort port) {}

  /** They are being opened. */
  record Opening() implements PortsState {}

  /**
   * They listen, as far as they can be had.
   *
   * @param address of the interface, as people write it before a colon; the first of a cell
   * @param exposed whether other computers reach it
   * @param ports in the order of the real box's documentation
   * @param missing those that cannot be had
   */
  record Open(String address, boolean exposed, List<OpenPort> ports, List<MissingPort> missing)
      implements PortsState {
    public Open {
      ports = List.copyOf(ports);
      missing = List.copyOf(missing);
    }
  }
}
