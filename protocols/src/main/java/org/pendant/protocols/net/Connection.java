package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Terms;

/**
 * Connection of one peer to a port. Sending never waits for the peer: what it does not take at once
 * goes to a bounded outbox, and a thread of the connection's own carries that out. Most messages go
 * out in the sender's thread for this reason: waking another one for each would make the intervals
 * of what is sent at a rate as uneven as the machine is busy.
 */
public final class Connection implements Occupant, WireEnd {
  private static final int RECEIVE_BYTES = 1 << 16;

  /** Who takes nothing for this long of what waits for it counts as not reading. */
  private static final Duration SLOW = Duration.ofSeconds(5);

  /** Who takes nothing for this long is disconnected. */
  static final Duration NOT_READING = Duration.ofSeconds(60);

  /** The same for a connection that ends when everything has gone out. */
  static final Duration ENDING_NOT_READING = Duration.ofSeconds(10);

  /** And for how long such an end may take at most. */
  static final Duration ENDING = Duration.ofSeconds(60);

  private final TcpPort port;
  private final String name;
  private final InetSocketAddress peer;
  private final InetSocketAddress local;
  private final SocketChannel channel;
  private final Readiness readable;
  private final Readiness writable;
  private final Outbox outbox;
  private final AtomicBoolean open = new AtomicBoolean(true);
  private final AtomicLong dropped = new AtomicLong();
  private final long openedNs;
  private final LongSupplier nanoTime;
  private final Consumer<Connection> afterwards;
  private volatile boolean sendingFailed;
  private volatile boolean receivingEnded;
  private volatile boolean spoken;
  private volatile long heardNs;
  private volatile long endingSinceNs;
  private volatile boolean ending;
  private volatile long received;
  private volatile Optional<Terms> terms = Optional.empty();

  /** Changed under the outbox's lock only. */
  private volatile long sent;

  /**
   * Takes a channel over.
   *
   * @param port where the peer has come
   * @param nanoTime a clock, ns
   * @param afterwards called when it is closed, more than once perhaps
   * @throws IOException if it is closed already
   */
  Connection(
      TcpPort port,
      InetSocketAddress peer,
      SocketChannel channel,
      LongSupplier nanoTime,
      Consumer<Connection> afterwards)
      throws IOException {
    this.port = port;
    name = text("clientAt", port.name(), peer.getAddress().getHostAddress(), peer.getPort());
    this.peer = peer;
    local = (InetSocketAddress) channel.getLocalAddress();
    this.channel = channel;
    this.nanoTime = nanoTime;
    this.afterwards = afterwards;
    openedNs = nanoTime.getAsLong();
    heardNs = openedNs;
    channel.configureBlocking(false);
    outbox = new Outbox(channel::write, this::goesOut, nanoTime);
    readable = new Readiness(channel, SelectionKey.OP_READ);
    writable = new Readiness(channel, SelectionKey.OP_WRITE);
  }

  /** Protocol and address, such as {@code RTDE client 127.0.0.1:53422}. */
  public String name() {
    return name;
  }

  /** What is logged about it: its name, and {@code message}. */
  public String says(String message) {
    String host = peer.getAddress().getHostAddress();
    return text("clientSays", port.name(), host, peer.getPort(), message);
  }

  @Override
  public InetSocketAddress peer() {
    return peer;
  }

  @Override
  public String portName() {
    return port.name();
  }

  @Override
  public InetSocketAddress local() {
    return local;
  }

  @Override
  public boolean outgoing() {
    return false;
  }

  /** How long it has stood. */
  public Duration age() {
    return Duration.ofNanos(nanoTime.getAsLong() - openedNs);
  }

  /** How many bytes have come. */
  public long receivedBytes() {
    return received;
  }

  /** How many bytes were sent, those that wait among them. */
  public long sentBytes() {
    return sent;
  }

  /** How many bytes wait, because the peer does not read. */
  public int unsentBytes() {
    return outbox.waitingBytes();
  }

  @Override
  public Optional<Terms> terms() {
    return terms;
  }

  /** Something has been agreed on. */
  public void agree(Terms now) {
    terms = Optional.of(now);
  }

  @Override
  public Dissector dissector() {
    return port.dissector();
  }

  @Override
  public InetAddress address() {
    return peer.getAddress();
  }

  @Override
  public Silence silence(long nowNs) {
    long untakenNs = nowNs - outbox.takenNs();
    if (untakenNs > SLOW.toNanos() && outbox.waits()) {
      return new Silence(Silence.Kind.NOT_READING, untakenNs);
    }
    return spoken
        ? new Silence(Silence.Kind.SPOKEN, Math.min(untakenNs, nowNs - heardNs))
        : new Silence(Silence.Kind.NEVER_SPOKEN, nowNs - heardNs);
  }

  /** Why this cannot continue; empty if it can. */
  Optional<String> overdue(IdleLimits limits, long nowNs) {
    Silence silence = silence(nowNs);
    Duration most = ending ? ENDING_NOT_READING : NOT_READING;
    if (silence.kind() == Silence.Kind.NOT_READING && silence.lastsNs() > most.toNanos()) {
      return Optional.of(text("hasReadNothing", most.toSeconds()));
    }
    if (ending && nowNs - endingSinceNs > ENDING.toNanos()) {
      return Optional.of(text("hasNotReadTheRest", ENDING.toSeconds()));
    }
    return ending ? Optional.empty() : limits.exceeded(silence);
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
    if (!offer(message) && !outbox.closed()) {
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
    if (!offer(message)) {
      dropped.incrementAndGet();
    }
  }

  private boolean offer(byte[] message) {
    try {
      return outbox.offer(message);
    } catch (IOException e) {
      sendingFailed();
      return false;
    }
  }

  private void goesOut(byte[] message) {
    long before = sent;
    sent = before + message.length;
    Optional<WireTap> tap = port.tap();
    if (tap.isPresent()) {
      tap.get().sent(this, before, message);
    }
  }

  /** How many messages of {@link #stream} were left out. */
  public long dropped() {
    return dropped.get();
  }

  /** Ends the connection when all that was sent has gone out. */
  public void closeAfterSending() {
    endAfterSending();
  }

  private void endAfterSending() {
    endingSinceNs = ending ? endingSinceNs : nanoTime.getAsLong();
    ending = true;
    outbox.close();
  }

  /** Ends the connection at once. */
  public void close() {
    open.set(false);
    outbox.abandon();
    closeChannel();
    afterwards.accept(this);
  }

  private void closeChannel() {
    try {
      channel.close();
    } catch (IOException e) {
      // it is gone for us either way
      open.set(false);
    }
    readable.wake();
    writable.wake();
  }

  /** Carries out what waits to be sent, until the end. */
  void write() {
    try (writable) {
      while (outbox.awaitWaiting()) {
        while (!outbox.writeWaiting()) {
          writable.await();
        }
      }
    } catch (IOException e) {
      sendingFailed();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (!sendingFailed) {
      close();
    }
  }

  /** Who sends and is gone at once still has what it sent read. */
  private void sendingFailed() {
    open.set(false);
    sendingFailed = true;
    outbox.abandon();
    if (receivingEnded) {
      close();
    }
  }

  /** Nothing more comes: who has closed only its sending side still gets its answers. */
  void receivingEnded() {
    endAfterSending();
    receivingEnded = true;
    if (sendingFailed) {
      close();
    }
  }

  private void hasCome(ByteBuffer bytes) {
    long before = received;
    received = before + bytes.remaining();
    Optional<WireTap> tap = port.tap();
    if (tap.isPresent()) {
      tap.get().received(this, before, bytes);
    }
  }

  /** Hands everything that comes to a session, until the end. */
  void read(Session session) throws ProtocolException {
    ByteBuffer bytes = ByteBuffer.allocate(RECEIVE_BYTES);
    try (readable) {
      for (int count = channel.read(bytes); count >= 0; count = channel.read(bytes)) {
        if (count == 0) {
          readable.await();
        } else {
          spoken = true;
          heardNs = nanoTime.getAsLong();
          bytes.flip();
          hasCome(bytes);
          session.received(bytes);
          bytes.clear();
        }
      }
    } catch (IOException e) {
      // reset by the peer, or closed by us
      open.set(false);
    }
  }
}
