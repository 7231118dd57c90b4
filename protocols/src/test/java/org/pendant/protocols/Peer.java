package org.pendant.protocols;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/** A server on a free port of this computer that does to each client what a test wants. */
public final class Peer implements AutoCloseable {
  private final ServerSocket server;
  private final Conversation conversation;
  private final Thread acceptor;
  private final List<Socket> clients = new CopyOnWriteArrayList<>();

  /** What happens to one client; then its connection is closed. */
  @FunctionalInterface
  public interface Conversation {
    void with(Socket client) throws IOException, InterruptedException;
  }

  private Peer(Conversation conversation) {
    this.conversation = conversation;
    acceptor = Thread.ofVirtual().name("peer").unstarted(this::accept);
    try {
      server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A server that begins at once. */
  public static Peer that(Conversation conversation) {
    Peer peer = new Peer(conversation);
    peer.acceptor.start();
    return peer;
  }

  /** Its port. */
  public int port() {
    return server.getLocalPort();
  }

  /** How many clients have come so far. */
  public int clients() {
    return clients.size();
  }

  private void accept() {
    try {
      while (true) {
        Socket client = server.accept();
        clients.add(client);
        Thread.ofVirtual().name("peer").start(() -> converse(client));
      }
    } catch (IOException e) {
      // closed: the test is over
    }
  }

  private void converse(Socket client) {
    try (client) {
      client.setTcpNoDelay(true);
      conversation.with(client);
    } catch (IOException e) {
      // the client is gone, which some tests want
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Ends listening; the port is free when this returns. */
  @Override
  public void close() throws IOException {
    server.close();
    try {
      acceptor.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    for (Socket client : clients) {
      client.close();
    }
  }
}
