package org.pendant.protocols.net;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;

/**
 * One peer of a port. Sending never waits for the peer: messages go to a bounded outbox, and a
 * thread of the connection's own carries them out.
 */
public final class Connection {
  private static final int RECEIVE_BYTES = 1 << 16;

  private final String name;
  private final InetSocketAddress peer;
  private final SocketChannel channel;
  private final Outbox outbox = new Outbox();
  private final AtomicBoolean open = new AtomicBoolean(true);
  private final AtomicLong dropped = new AtomicLong();

  Connection(String name, InetSocketAddress peer, SocketChannel channel) {
    this.name = name;
    this.peer = peer;
    this.channel = channel;
  }

  /** Protocol and address, such as {@code RTDE client 127.0.0.1:53422}. */
  public String name() {
    return name;
  }

  /** Where the peer is. */
  public InetSocketAddress peer() {
    return peer;
  }

  /** Whether it still stands, as far as this side knows. */
  public boolean open() {
    return open.get();
  }

  /**
   * Sends a message; a peer that has not read the last megabyte is disconnected.
   *
   * @param message not changed any more by the caller
   */
  public void send(byte[] message) {
    if (!outbox.offer(message) && open.get()) {
      close();
    }
  }

  /**
   * Sends one of many messages that are out of date soon: left out as a whole where the peer does
   * not read fast enough.
   *
   * @param message not changed any more by the caller
   */
  public void stream(byte[] message) {
    if (!outbox.offer(message)) {
      dropped.incrementAndGet();
    }
  }

  /** How many messages of {@link #stream} were left out. */
  public long dropped() {
    return dropped.get();
  }

  /** Ends the connection when all that was sent has gone out. */
  public void closeAfterSending() {
    outbox.close();
  }

  /** Ends the connection at once. */
  public void close() {
    open.set(false);
    outbox.close();
    closeChannel();
  }

  private void closeChannel() {
    try {
      channel.close();
    } catch (IOException e) {
      // it is gone for us either way
      open.set(false);
    }
  }

  /** Carries out what is sent, until the end. */
  void write() {
    try {
      for (byte[] next = outbox.take(); next != null; next = outbox.take()) {
        ByteBuffer bytes = ByteBuffer.wrap(next);
        while (bytes.hasRemaining()) {
          channel.write(bytes);
        }
      }
    } catch (IOException e) {
      // the peer has gone; the reading side notices as well
      open.set(false);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    close();
  }

  /** Hands everything that comes to a session, until the end. */
  void read(Session session) throws ProtocolException {
    ByteBuffer bytes = ByteBuffer.allocate(RECEIVE_BYTES);
    try {
      while (channel.read(bytes) >= 0) {
        bytes.flip();
        session.received(bytes);
        bytes.clear();
      }
    } catch (IOException e) {
      // reset by the peer, or closed by us
      open.set(false);
    }
  }
}
