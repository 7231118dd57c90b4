package org.pendant.protocols.interpreter;

import static org.pendant.protocols.interpreter.InterpreterTexts.text;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.wire.LineDissector;

/** Interpreter server: the port of interpreter mode (manual 13). */
public final class InterpreterServer implements Server {
  /** Where it listens on a real box. */
  public static final int STANDARD_PORT = 30_020;

  private final TcpPort port;
  private final InterpreterLog log;

  private InterpreterServer(TcpPort port, InterpreterLog log) {
    this.port = port;
    this.log = log;
  }

  /**
   * Begins to listen.
   *
   * @param logs folder for the log files; made when something is logged
   * @throws IOException if the port cannot be had
   */
  public static InterpreterServer open(ServerContext serverContext, PortNumbers numbers, Path logs)
      throws IOException {
    TcpPort port =
        TcpPort.open(
            numbers
                .listening(text("portName"), STANDARD_PORT)
                .readBy(() -> new LineDissector(InterpreterServer::effect)),
            connection ->
                new InterpreterSession(
                    connection, serverContext.robot(), serverContext.remote().mayControl()),
            serverContext.log());
    return new InterpreterServer(port, InterpreterLog.start(serverContext, logs));
  }

  private static Optional<String> effect(String line) {
    return line.isBlank() || ControlLine.of(line).filter(ControlLine::asks).isPresent()
        ? Optional.empty()
        : Optional.of(line.strip());
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }

  @Override
  public void close() {
    port.close();
    log.close();
  }
}
