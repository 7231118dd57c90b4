package org.pendant.editors.wire;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;

/**
 * Loopback listener: a port of this computer alone, at which each client gets a session of its own.
 */
public final class LoopbackListener implements AutoCloseable {
  /** The most clients at once; further ones wait. */
  public static final int MAX_CLIENTS = 16;

  private static final int BACKLOG = 16;

  private final ServerSocket listener;
  private final Set<Socket> clients = ConcurrentHashMap.newKeySet();
  private final Semaphore places = new Semaphore(MAX_CLIENTS);

  /** One session with one client, until it ends. */
  @FunctionalInterface
  public interface Session {
    void serve(InputStream input, OutputStream output) throws IOException, InterruptedException;
  }

  /**
   * Opens a port.
   *
   * @param port 0 for one that is free
   * @throws IOException if it is taken
   */
  public LoopbackListener(int port) throws IOException {
    listener = new ServerSocket(port, BACKLOG, InetAddress.getLoopbackAddress());
  }

  public int port() {
    return listener.getLocalPort();
  }

  /** Serves clients, several at once, until the listener is closed; the caller waits. */
  public void serve(Session session) {
    while (!listener.isClosed()) {
      try {
        places.acquire();
        Socket client = listener.accept();
        Thread.ofVirtual().name("editor").start(() -> serve(session, client));
      } catch (IOException e) {
        places.release();
        return;
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  private void serve(Session session, Socket client) {
    clients.add(client);
    try (client) {
      client.setTcpNoDelay(true);
      session.serve(client.getInputStream(), client.getOutputStream());
    } catch (IOException e) {
      // The client went away in the middle: its session is over.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      clients.remove(client);
      places.release();
    }
  }

  /** Has all clients leave that are there; further ones may come. */
  public void disconnect() {
    for (Socket each : clients) {
      try {
        each.close();
      } catch (IOException e) {
        // it is gone, which is all that is wanted
      }
    }
  }

  @Override
  public void close() throws IOException {
    listener.close();
  }
}
