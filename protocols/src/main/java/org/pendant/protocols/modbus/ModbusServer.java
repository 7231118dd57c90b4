package org.pendant.protocols.modbus;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.locks.ReadWriteLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import org.pendant.protocols.net.IdleLimits;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;

/**
 * Modbus server of a control box. Every request is answered from one snapshot; what is written
 * shows in the next one. Local control does not keep clients from writing: what they reach are
 * signals, not commands.
 */
public final class ModbusServer implements Server {
  /** Where it listens on a real box. */
  public static final int STANDARD_PORT = 502;

  private final TcpPort port;

  private ModbusServer(TcpPort port) {
    this.port = port;
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had
   */
  public static ModbusServer open(ServerContext serverContext, PortNumbers numbers)
      throws IOException {
    return open(serverContext, numbers.listening("Modbus", STANDARD_PORT));
  }

  /**
   * Begins to listen anywhere.
   *
   * @throws IOException if the port cannot be had
   */
  public static ModbusServer open(ServerContext serverContext, Listening listening)
      throws IOException {
    ReadWriteLock changing = new ReentrantReadWriteLock();
    return new ModbusServer(
        TcpPort.open(
            listening.with(IdleLimits.peerBegins()).readBy(ModbusDissector::new),
            connection -> {
              SignalHandler signalHandler =
                  new SignalHandler(serverContext.robot(), connection.name());
              return new ModbusSession(
                  connection, new Answers(signalHandler, changing), serverContext.log());
            },
            serverContext.log()));
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
