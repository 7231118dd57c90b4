package org.pendant.protocols.trace;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleSupplier;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.wire.Direction;

/** Live trace: the newest messages of all connections, for a screen. Any thread. */
public final class LiveTrace implements AutoCloseable {
  private final MessageBuffer buffer = new MessageBuffer();
  private final WireTrace trace;

  /**
   * Begins a trace; {@link #tap} is to be given to the ports.
   *
   * @param robotTimeS robot time, s; any thread, must not wait
   */
  public LiveTrace(DoubleSupplier robotTimeS) {
    trace = new WireTrace(robotTimeS, InstantSource.system(), buffer, why -> {}).start();
  }

  /** What hears the connections. */
  public WireTap tap() {
    return trace;
  }

  /** A number that is another one whenever there are other messages. */
  public long newest() {
    return buffer.newest();
  }

  /** How many messages, or pieces of them, came faster than they could be read. */
  public long leftOut() {
    return buffer.leftOut();
  }

  /**
   * The messages that are kept, the oldest first.
   *
   * @param withStreamed also those that come at a rate
   */
  public List<WireMessage> messages(boolean withStreamed) {
    return buffer.messages(withStreamed);
  }

  /** How many messages have gone each way, of the clients that are connected. */
  public Map<Peers, MessageCounts> counts() {
    return buffer.counts();
  }

  /** The ports do not have the tap any more, for a while. */
  public void pause() {
    buffer.pause();
  }

  /** Forgets the messages that are kept. */
  public void clear() {
    buffer.clear();
  }

  /**
   * Writes messages as a {@link TraceFile} has them.
   *
   * @param name says in which form
   */
  public static void write(List<WireMessage> messages, Path name, OutputStream file)
      throws IOException {
    if (!TraceFile.packets(name)) {
      try (JsonWriter writer = new JsonWriter(file)) {
        for (WireMessage each : messages) {
          writer.write(each);
        }
      }
      return;
    }
    try (PcapWriter writer = new PcapWriter(file)) {
      Map<Peers, PastStream> streams = new HashMap<>();
      for (WireMessage each : messages) {
        streams.computeIfAbsent(each.peers(), PastStream::new).write(writer, each);
      }
    }
  }

  /** A connection of which only some messages are known: its bytes are numbered from the first. */
  private static final class PastStream {
    private final TcpStream stream;
    private long in;
    private long out;

    PastStream(Peers peers) {
      stream = new TcpStream(peers);
    }

    void write(PcapWriter writer, WireMessage message) throws IOException {
      int count = message.bytes().remaining();
      boolean comes = message.direction() == Direction.IN;
      stream.write(
          writer,
          message.epochUs(),
          message.direction(),
          comes ? in : out,
          message.bytes().duplicate());
      in += comes ? count : 0;
      out += comes ? 0 : count;
    }
  }

  /** Ends it; what is kept can still be asked for. */
  @Override
  public void close() {
    trace.close();
  }
}
