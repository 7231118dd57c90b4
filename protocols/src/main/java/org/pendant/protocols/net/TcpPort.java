package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.protocols.wire.Dissector;

/** TCP port at which one protocol is spoken. Each peer has threads of its own. */
public final class TcpPort implements AutoCloseable {
  /** A session that has not let go of a closed port by then never will. */
  private static final Duration PATIENCE = Duration.ofSeconds(1);

  /** How often silent peers are looked for, ns. */
  private static final long LOOK_NS = 1_000_000_000;

  private final Listening listening;
  private final Protocol protocol;
  private final PeerLog log;
  private final ServerSocketChannel server;
  private final LongSupplier nanoTime;
  private final ConnectionSlots<Connection> slots;
  private final PeriodicTasks watch;
  private final Thread acceptor;
  private volatile Optional<WireTap> tap = Optional.empty();
  private volatile Runnable greeted = () -> {};

  private TcpPort(
      Listening listening,
      Protocol protocol,
      PeerLog log,
      LongSupplier nanoTime,
      ServerSocketChannel server) {
    this.listening = listening;
    this.protocol = protocol;
    this.log = log;
    this.nanoTime = nanoTime;
    this.server = server;
    slots = new ConnectionSlots<>(listening.mostConnections());
    watch = new PeriodicTasks(Thread.ofVirtual().name(listening.name() + " watch"), log);
    acceptor =
        Thread.ofVirtual()
            .name(listening.name() + " port")
            .unstarted(new Acceptor<>(listening.name(), new Door(), Thread::sleep, log));
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had; the message names protocol, address and port
   */
  public static TcpPort open(Listening listening, Protocol protocol, PeerLog log)
      throws IOException {
    return open(listening, protocol, log, System::nanoTime);
  }

  static TcpPort open(Listening listening, Protocol protocol, PeerLog log, LongSupplier nanoTime)
      throws IOException {
    ServerSocketChannel server = ServerSocketChannel.open();
    try {
      server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
      server.bind(
          new InetSocketAddress(listening.host(), listening.port()), listening.mostConnections());
    } catch (BindException e) {
      server.close();
      throw new BindException(
          text(
              "portCannotBeHad",
              listening.name(),
              listening.port(),
              listening.host().getHostAddress(),
              e.getMessage()));
    }
    TcpPort port = new TcpPort(listening, protocol, log, nanoTime, server);
    port.acceptor.start();
    port.watch.withPauses(text("watchOfPort", listening.name()), LOOK_NS, port::look);
    return port;
  }

  /** The number it listens at. */
  public int number() {
    return server.socket().getLocalPort();
  }

  /** Its name, for messages. */
  public String name() {
    return listening.name();
  }

  /** A new dissector for one of its connections. */
  Dissector dissector() {
    return listening.dissector().get();
  }

  /** What listens to its connections. */
  Optional<WireTap> tap() {
    return tap;
  }

  /** Has {@code listener} hear from now on what goes over all its connections; empty for nobody. */
  public void tap(Optional<WireTap> listener) {
    tap = listener;
  }

  /** Has {@code greeted} run whenever a peer has connected; it must be short. */
  public void whenConnected(Runnable greeted) {
    this.greeted = greeted;
  }

  /** Whether any peer is connected now. */
  public boolean connected() {
    return slots.taken();
  }

  /** The peers that are connected now. */
  public List<Connection> connections() {
    return slots.occupants();
  }

  /** The port as the acceptor sees it. */
  private final class Door implements Acceptor.Door<SocketChannel> {
    @Override
    public boolean open() {
      return server.isOpen();
    }

    @Override
    public SocketChannel accept() throws IOException {
      return server.accept();
    }

    @Override
    public void greet(SocketChannel peer) throws IOException {
      try {
        TcpPort.this.greet(peer);
      } catch (IOException | RuntimeException | Error e) {
        peer.close();
        throw e;
      }
    }
  }

  private void greet(SocketChannel channel) throws IOException {
    InetSocketAddress peer = (InetSocketAddress) channel.getRemoteAddress();
    channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
    KeepAlive.set(channel);
    Connection connection = new Connection(this, peer, channel, nanoTime, slots::free);
    String name = connection.name();
    ConnectionSlots.Admission<Connection> admission = slots.admit(connection, nanoTime.getAsLong());
    admission
        .givenUp()
        .ifPresent(silent -> disconnect(silent, text("silentAndOthersWantItsPlace")));
    if (!admission.taken()) {
      connection.close();
      log.write(Level.WARNING, text("refusedAsFull", name, listening.mostConnections()));
      return;
    }
    if (!server.isOpen()) {
      // closed meanwhile, perhaps too early to find this one
      connection.close();
      return;
    }
    log.visit(text("hasConnected", name));
    greeted.run();
    tap.ifPresent(each -> each.opened(connection));
    Thread.ofVirtual().name(name + " sending").start(connection::write);
    Thread.ofVirtual().name(name).start(() -> converse(connection));
  }

  private void converse(Connection connection) {
    try {
      Session session = protocol.connected(connection);
      try {
        connection.read(session);
      } catch (ProtocolException e) {
        log.write(Level.WARNING, text("wasDisconnected", connection.name(), e.getMessage()));
      } finally {
        connection.receivingEnded();
        session.closed();
      }
    } catch (RuntimeException e) {
      log.write(Level.ERROR, text("internalError", connection.name(), e));
      connection.close();
    } finally {
      tap.ifPresent(each -> each.closed(connection));
      log.visit(text("hasLeft", connection.name()));
    }
  }

  /** Disconnects who has not been heard of for too long, or does not read what it is sent. */
  void look() {
    long nowNs = nanoTime.getAsLong();
    for (Connection each : slots.occupants()) {
      each.overdue(listening.idle(), nowNs).ifPresent(why -> disconnect(each, why));
    }
  }

  private void disconnect(Connection connection, String why) {
    log.write(Level.WARNING, text("wasDisconnected", connection.name(), why));
    connection.close();
  }

  /** Ends all connections; new ones are accepted. */
  public void disconnectAll() {
    slots.occupants().forEach(Connection::close);
  }

  /** Ends listening and all connections; the port can be had again afterwards. */
  @Override
  public void close() {
    watch.close();
    try {
      server.close();
    } catch (IOException e) {
      log.write(Level.WARNING, listening.name() + ": " + e.getMessage());
    }
    disconnectAll();
    awaitAcceptor();
  }

  /** The system keeps the port until the thread that waits for connections has let go of it. */
  private void awaitAcceptor() {
    // it may wait for the system to give more
    acceptor.interrupt();
    try {
      if (!acceptor.join(PATIENCE)) {
        log.write(Level.WARNING, text("portStillInUse", listening.name()));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
