package org.pendant.protocols.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Message buffer: the newest messages, with a bound on their number and bytes. Those that come at a
 * rate have a bound of their own, so that they do not push the others out. Any thread.
 */
final class MessageBuffer implements TraceSink {
  private final MessageReader reader = new MessageReader(this::keep);
  private final Shelf single = new Shelf(10_000);
  private final Shelf streamed = new Shelf(5_000);
  private final Map<Peers, MessageCounts> counts = new HashMap<>();
  private long newest;
  private long leftOut;

  /** Messages of one kind, the oldest first. */
  private static final class Shelf {
    private static final long MAX_BYTES = 16L << 20;

    private final int most;
    private final ArrayDeque<WireMessage> messages = new ArrayDeque<>();
    private long bytes;

    Shelf(int most) {
      this.most = most;
    }

    void add(WireMessage message) {
      messages.add(message);
      bytes += message.bytes().remaining();
      while (messages.size() > most || bytes > MAX_BYTES) {
        bytes -= messages.remove().bytes().remaining();
      }
    }

    void clear() {
      messages.clear();
      bytes = 0;
    }
  }

  @Override
  public synchronized void take(WireEvent event) {
    reader.take(event);
    if (event.kind() == WireEvent.Kind.CLOSED) {
      counts.remove(Peers.of(event.connection()));
    }
  }

  private void keep(WireMessage message) {
    newest++;
    (message.streamed() ? streamed : single).add(message);
    counts.merge(
        message.peers(), MessageCounts.NONE.and(message), (before, one) -> before.and(message));
  }

  @Override
  public synchronized void leftOut(long count, long epochUs) {
    leftOut += count;
  }

  /** Nothing is heard for a while. */
  synchronized void pause() {
    reader.forget();
    counts.clear();
  }

  /** How many have come; changes with each. */
  synchronized long newest() {
    return newest;
  }

  /** How many found no room. */
  synchronized long leftOut() {
    return leftOut;
  }

  /** What is kept, the oldest first. */
  synchronized List<WireMessage> messages(boolean withStreamed) {
    List<WireMessage> all = new ArrayList<>(single.messages);
    if (withStreamed) {
      all.addAll(streamed.messages);
      all.sort((one, other) -> Long.compare(one.number(), other.number()));
    }
    return all;
  }

  /** How many messages have gone each way, of the clients that are connected. */
  synchronized Map<Peers, MessageCounts> counts() {
    return Map.copyOf(counts);
  }

  /** Forgets what is kept. */
  synchronized void clear() {
    single.clear();
    streamed.clear();
    newest++;
  }

  @Override
  public void flush() {}

  @Override
  public void close() {}
}
