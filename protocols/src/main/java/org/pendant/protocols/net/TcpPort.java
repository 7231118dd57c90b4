package org.pendant.protocols.net;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.message.LogEntry.Level;

/** A TCP port at which one protocol is spoken. Each peer has threads of its own. */
public final class TcpPort implements AutoCloseable {
  /** Somebody who has not let go of a closed port by then never will. */
  private static final Duration PATIENCE = Duration.ofSeconds(1);

  private final Listening listening;
  private final Protocol protocol;
  private final PeerLog log;
  private final ServerSocketChannel server;
  private final Set<Connection> connections = ConcurrentHashMap.newKeySet();
  private final Thread acceptor;

  private TcpPort(Listening listening, Protocol protocol, PeerLog log, ServerSocketChannel server) {
    this.listening = listening;
    this.protocol = protocol;
    this.log = log;
    this.server = server;
    acceptor = Thread.ofVirtual().name(listening.name() + " port").unstarted(this::accept);
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had; the message names protocol, address and port
   */
  public static TcpPort open(Listening listening, Protocol protocol, PeerLog log)
      throws IOException {
    ServerSocketChannel server = ServerSocketChannel.open();
    try {
      server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
      server.bind(
          new InetSocketAddress(listening.host(), listening.port()), listening.mostConnections());
    } catch (BindException e) {
      server.close();
      throw new BindException(
          listening.name()
              + ": port "
              + listening.port()
              + " of "
              + listening.host().getHostAddress()
              + " cannot be had: "
              + e.getMessage());
    }
    TcpPort port = new TcpPort(listening, protocol, log, server);
    port.acceptor.start();
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

  /** The peers that are connected now. */
  public List<Connection> connections() {
    return List.copyOf(connections);
  }

  private void accept() {
    while (server.isOpen()) {
      try {
        accept(server.accept());
      } catch (IOException e) {
        if (server.isOpen()) {
          log.write(Level.WARNING, listening.name() + ": a connection failed: " + e.getMessage());
        }
      }
    }
  }

  private void accept(SocketChannel channel) throws IOException {
    try {
      greet(channel);
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  private void greet(SocketChannel channel) throws IOException {
    InetSocketAddress peer = (InetSocketAddress) channel.getRemoteAddress();
    String name =
        listening.name() + " client " + peer.getAddress().getHostAddress() + ":" + peer.getPort();
    if (connections.size() >= listening.mostConnections()) {
      channel.close();
      log.write(
          Level.WARNING,
          name + " was refused: " + listening.mostConnections() + " are connected already");
      return;
    }
    channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
    Connection connection = new Connection(name, peer, channel, connections::remove);
    connections.add(connection);
    if (!server.isOpen()) {
      // closed meanwhile, perhaps too early to find this one
      connection.close();
      return;
    }
    Thread.ofVirtual().name(name + " sending").start(connection::write);
    Thread.ofVirtual().name(name).start(() -> converse(connection));
  }

  private void converse(Connection connection) {
    try {
      Session session = protocol.connected(connection);
      try {
        connection.read(session);
      } catch (ProtocolException e) {
        log.write(Level.WARNING, connection.name() + " was disconnected: " + e.getMessage());
      } finally {
        connection.receivingEnded();
        session.closed();
      }
    } catch (RuntimeException e) {
      log.write(Level.ERROR, connection.name() + ": internal error: " + e);
      connection.close();
    }
  }

  /** Ends all connections; new ones are accepted. */
  public void disconnectAll() {
    connections.forEach(Connection::close);
  }

  /** Ends listening and all connections; the port can be had again afterwards. */
  @Override
  public void close() {
    try {
      server.close();
    } catch (IOException e) {
      log.write(Level.WARNING, listening.name() + ": " + e.getMessage());
    }
    disconnectAll();
    awaitAcceptor();
  }

  /** The system keeps the port until whoever waits for connections has let go of it. */
  private void awaitAcceptor() {
    try {
      if (!acceptor.join(PATIENCE)) {
        log.write(Level.WARNING, listening.name() + ": the port is still in use");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
