package org.pendant.protocols.eip;

import static org.pendant.protocols.eip.EipTexts.text;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.DatagramChannel;
import java.util.function.BiConsumer;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.PeerLog;

/** UDP port. What comes is handed on in one thread; anybody may send. */
final class UdpPort implements AutoCloseable {
  /** Longer datagrams are cut off, and so no packet of ours any more. */
  private static final int LONGEST = 2048;

  private final Listening listening;
  private final DatagramChannel channel;
  private final PeerLog log;

  private UdpPort(Listening listening, DatagramChannel channel, PeerLog log) {
    this.listening = listening;
    this.channel = channel;
    this.log = log;
  }

  /**
   * Takes the port; nothing is received before {@link #receive}.
   *
   * @throws IOException if the port cannot be had; the message names protocol, address and port
   */
  static UdpPort open(Listening listening, PeerLog log) throws IOException {
    DatagramChannel channel = DatagramChannel.open();
    try {
      channel.bind(new InetSocketAddress(listening.host(), listening.port()));
    } catch (BindException e) {
      channel.close();
      throw new BindException(
          text(
              "udpPortCannotBeHad",
              listening.name(),
              listening.port(),
              listening.host().getHostAddress(),
              e.getMessage()));
    }
    return new UdpPort(listening, channel, log);
  }

  /** Begins to hand on what comes; {@code listener} must not keep the buffer. */
  void receive(BiConsumer<ByteBuffer, InetSocketAddress> listener) {
    Thread.ofPlatform().daemon().name(listening.name()).start(() -> run(listener));
  }

  private void run(BiConsumer<ByteBuffer, InetSocketAddress> listener) {
    ByteBuffer bytes = ByteBuffer.allocate(LONGEST).order(ByteOrder.LITTLE_ENDIAN);
    while (channel.isOpen()) {
      bytes.clear();
      try {
        InetSocketAddress from = (InetSocketAddress) channel.receive(bytes);
        listener.accept(bytes.flip(), from);
      } catch (IOException e) {
        if (channel.isOpen()) {
          log.write(Level.WARNING, listening.name() + ": " + e.getMessage());
        }
      } catch (RuntimeException e) {
        log.write(Level.ERROR, text("internalError", listening.name(), e));
      }
    }
  }

  /** Sends a datagram; one that cannot be sent is lost, as on the wire. */
  void send(byte[] bytes, InetSocketAddress to) {
    try {
      channel.send(ByteBuffer.wrap(bytes), to);
    } catch (IOException e) {
      if (channel.isOpen()) {
        log.write(Level.WARNING, listening.name() + ": " + to + ": " + e.getMessage());
      }
    }
  }

  /** The number of the port. */
  int number() {
    return channel.socket().getLocalPort();
  }

  @Override
  public void close() {
    try {
      channel.close();
    } catch (IOException e) {
      log.write(Level.WARNING, listening.name() + ": " + e.getMessage());
    }
  }
}
