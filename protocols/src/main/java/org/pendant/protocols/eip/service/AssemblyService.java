package org.pendant.protocols.eip.service;

import java.io.IOException;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.serve.PortNumbers;

/** Listens for calls that configure assemblies. */
public final class AssemblyService {
  /** Where it listens on a real box. */
  public static final int STANDARD_PORT = 40_000;

  private AssemblyService() {}

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had
   */
  public static TcpPort open(PortNumbers numbers, Configuration configuration, PeerLog log)
      throws IOException {
    return TcpPort.open(
        numbers.listening("Fieldbus configuration", STANDARD_PORT),
        connection -> new ServiceSession(connection, new AssemblyCalls(configuration)),
        log);
  }
}
