package org.pendant.protocols.eip;

import static org.pendant.protocols.eip.EipTexts.text;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.protocols.eip.service.AssemblyService;
import org.pendant.protocols.eip.service.Configuration;
import org.pendant.protocols.net.IdleLimits;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;

/**
 * EtherNet/IP adapter of a control box, with the service that configures its assemblies. Local
 * control does not keep scanners from writing: what they reach are inputs and outputs, not
 * commands.
 */
public final class EipServer implements Server {
  /** Where it listens for messages on a real box, by TCP and UDP. */
  public static final int STANDARD_PORT = 44_818;

  private static final int ATTEMPTS = 10;

  private final TcpPort messages;
  private final TcpPort service;
  private final UdpPort discovery;
  private final UdpPort io;
  private final Connections connections;

  private EipServer(
      TcpPort messages, TcpPort service, UdpPort discovery, UdpPort io, Connections connections) {
    this.messages = messages;
    this.service = service;
    this.discovery = discovery;
    this.io = io;
    this.connections = connections;
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if one of the ports cannot be had
   */
  public static EipServer open(ServerContext serverContext, PortNumbers numbers)
      throws IOException {
    boolean anyFree = numbers.listening("EtherNet/IP", STANDARD_PORT).port() == 0;
    for (int attempt = 1; ; attempt++) {
      try {
        return openAll(serverContext, numbers);
      } catch (BindException e) {
        // The number that TCP was lent may be taken for UDP; another will not be.
        if (!anyFree || attempt == ATTEMPTS) {
          throw e;
        }
      }
    }
  }

  private static EipServer openAll(ServerContext serverContext, PortNumbers numbers)
      throws IOException {
    UdpPort io =
        UdpPort.open(
            numbers.listening("EtherNet/IP I/O", ConnectionHandler.STANDARD_IO_PORT),
            serverContext.log());
    AssemblyHandler assemblyHandler = new AssemblyHandler(serverContext.robot());
    Connections connections = new Connections(assemblyHandler, io, serverContext.log());
    Listening listening = numbers.listening("EtherNet/IP", STANDARD_PORT);
    Supplier<ByteBuffer> identity =
        () ->
            Encapsulation.identity(
                new InetSocketAddress(
                    listening.host(), listening.port() == 0 ? STANDARD_PORT : listening.port()),
                connections.status());
    MessageRouter router = router(listening, assemblyHandler, connections);
    AtomicInteger sessions = new AtomicInteger();
    try {
      TcpPort messages =
          TcpPort.open(
              listening.with(IdleLimits.peerBegins()).readBy(EipDissector::new),
              connection ->
                  new EipSession(
                      connection, sessions.incrementAndGet(), router, connections, identity),
              serverContext.log());
      try {
        return complete(serverContext, numbers, io, connections, messages, identity);
      } catch (IOException e) {
        messages.close();
        throw e;
      }
    } catch (IOException e) {
      connections.close();
      io.close();
      throw e;
    }
  }

  private static MessageRouter router(
      Listening listening, AssemblyHandler assemblyHandler, Connections connections) {
    Map<Integer, CipObject> objects =
        new HashMap<>(DeviceObjects.of(listening.host(), connections::status));
    objects.put(DeviceObjects.ASSEMBLY, new AssemblyObject(assemblyHandler, connections::received));
    return new MessageRouter(objects, new ConnectionHandler(connections, assemblyHandler));
  }

  private static EipServer complete(
      ServerContext serverContext,
      PortNumbers numbers,
      UdpPort io,
      Connections connections,
      TcpPort messages,
      Supplier<ByteBuffer> identity)
      throws IOException {
    AssemblyHandler assemblyHandler = new AssemblyHandler(serverContext.robot());
    UdpPort discovery =
        UdpPort.open(
            new Listening(text("discoveryPort"), numbers.host(), messages.number()),
            serverContext.log());
    try {
      Configuration configuration =
          new Configuration() {
            @Override
            public boolean add(AssemblyPair pair) throws InterruptedException {
              return assemblyHandler.configure(pair);
            }

            @Override
            public boolean connected(int fromScanner) {
              return connections.connected(fromScanner);
            }
          };
      TcpPort service = AssemblyService.open(numbers, configuration, serverContext.log());
      io.receive(connections::datagram);
      Discovery answers = new Discovery(messages.number(), identity);
      discovery.receive(
          (bytes, from) ->
              answers
                  .answer(bytes, from, System.nanoTime())
                  .ifPresent(answer -> discovery.send(answer, from)));
      return new EipServer(messages, service, discovery, io, connections);
    } catch (IOException e) {
      discovery.close();
      throw e;
    }
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(messages, service);
  }

  /** The number of the UDP port for cyclic data. */
  int ioPort() {
    return io.number();
  }

  @Override
  public void close() {
    ports().forEach(TcpPort::close);
    connections.close();
    discovery.close();
    io.close();
  }
}
