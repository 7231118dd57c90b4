package org.pendant.protocols.trace;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.protocols.net.WireEnd;
import org.pendant.protocols.trace.WireEvent.Kind;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.MessageCutter;
import org.pendant.protocols.wire.Reading;

/** Message reader: events of many connections as messages. One thread at a time. */
final class MessageReader {
  private final Consumer<WireMessage> messages;
  private final Map<WireEnd, Conversation> conversations = new HashMap<>();

  private long count;

  MessageReader(Consumer<WireMessage> messages) {
    this.messages = messages;
  }

  /**
   * Forgets what was begun: connections go on from what was agreed on when they are heard again.
   */
  void forget() {
    conversations.clear();
  }

  /** Takes the next event. */
  void take(WireEvent event) {
    WireEnd connection = event.connection();
    switch (event.kind()) {
      case OPENED -> {
        conversations.put(connection, new Conversation(connection, connection.dissector()));
        mark(event, "connected", TraceTexts.text("connected"));
      }
      case RECEIVED, SENT -> conversation(connection).take(event);
      case CLOSED -> {
        conversation(connection).end();
        conversations.remove(connection);
        mark(event, "closed", TraceTexts.text("closed"));
      }
    }
  }

  private void mark(WireEvent event, String type, String summary) {
    messages.accept(
        new WireMessage(
            ++count,
            Peers.of(event.connection()),
            event.connection().outgoing() ? Direction.OUT : Direction.IN,
            event.epochUs(),
            event.robotTimeS(),
            Reading.of(type, summary),
            event.bytes()));
  }

  /** One that stood before the trace goes on from what was agreed on. */
  private Conversation conversation(WireEnd connection) {
    return conversations.computeIfAbsent(
        connection,
        absent ->
            new Conversation(
                absent, absent.terms().map(each -> each.dissector()).orElseGet(absent::dissector)));
  }

  /** Both directions of a connection. */
  private final class Conversation {
    private final Peers peers;
    private final Stream in;
    private final Stream out;

    Conversation(WireEnd connection, Dissector dissector) {
      peers = Peers.of(connection);
      in = new Stream(Direction.IN, dissector);
      out = new Stream(Direction.OUT, dissector);
    }

    void take(WireEvent event) {
      (event.kind() == Kind.RECEIVED ? in : out).take(event);
    }

    void end() {
      in.cutter.missed();
      out.cutter.missed();
    }

    /** One of the directions. */
    private final class Stream {
      private final Direction direction;
      private final MessageCutter cutter;
      private Optional<WireEvent> latest = Optional.empty();

      Stream(Direction direction, Dissector dissector) {
        this.direction = direction;
        cutter = new MessageCutter(direction, dissector, this::hand);
      }

      void take(WireEvent event) {
        boolean whole =
            latest
                .filter(last -> last.before() + last.bytes().remaining() != event.before())
                .isEmpty();
        if (!whole) {
          cutter.missed();
        }
        latest = Optional.of(event);
        cutter.take(event.bytes());
      }

      private void hand(Reading reading, ByteBuffer bytes) {
        WireEvent at = latest.orElseThrow();
        messages.accept(
            new WireMessage(
                ++count, peers, direction, at.epochUs(), at.robotTimeS(), reading, bytes));
      }
    }
  }
}
