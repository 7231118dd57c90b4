package org.pendant.protocols.eip.service;

import static org.pendant.protocols.eip.service.AssemblyTexts.text;

import java.io.IOException;
import java.time.Duration;
import org.pendant.protocols.http.HttpDissector;
import org.pendant.protocols.http.HttpSession;
import org.pendant.protocols.net.IdleLimits;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;

/** Assembly service: listens for calls that configure assemblies. */
public final class AssemblyService {
  /** Where it listens on a real box. */
  public static final int STANDARD_PORT = 40_000;

  /** Calls are made at once; who wants another one later connects again. */
  private static final Duration IDLE = Duration.ofSeconds(30);

  private AssemblyService() {}

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had
   */
  public static TcpPort open(PortNumbers numbers, Configuration configuration, PeerLog log)
      throws IOException {
    AssemblyCalls calls = new AssemblyCalls(configuration);
    return TcpPort.open(
        numbers
            .listening(text("portName"), STANDARD_PORT)
            .with(IdleLimits.of(IDLE))
            .readBy(HttpDissector::new),
        connection -> new HttpSession(connection, calls),
        log);
  }
}
