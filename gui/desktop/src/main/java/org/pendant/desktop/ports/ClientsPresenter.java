package org.pendant.desktop.ports;

import static org.pendant.desktop.ports.PortsTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.pendant.desktop.timeline.ClientMark;
import org.pendant.kit.text.Messages;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.trace.LiveTrace;
import org.pendant.protocols.trace.MessageCounts;
import org.pendant.protocols.trace.Peers;
import org.pendant.protocols.trace.WireMessage;
import org.pendant.protocols.wire.Terms;

/**
 * Clients presenter: what the screen of clients shows. It has no Swing; the dispatch thread uses
 * it. Messages are kept from the first look on, until they are no longer wanted.
 */
final class ClientsPresenter {
  /** What is shown is looked at so often. */
  private static final long LOOK_NS = TimeUnit.MILLISECONDS.toNanos(250);

  /** Rates are those of so long. */
  private static final long RATE_NS = TimeUnit.SECONDS.toNanos(1);

  /** Times of messages are not exactly in the order of messages. */
  private static final double CLOCKS_S = 0.1;

  private final DesktopPorts ports;
  private Optional<LiveTrace> trace = Optional.empty();
  private boolean recording = true;
  private MessageFilter filter = MessageFilter.USUAL;
  private List<ClientRow> clients = List.of();
  private List<WireMessage> messages = List.of();
  private final Map<Connection, Measured> traffic = new HashMap<>();
  private long lookedNs;
  private boolean looked;
  private long newest = -1;

  private List<ClientMark> marks = List.of();
  private long markedNs;
  private boolean marked;

  /** The latest traffic and the rates before it. */
  private record Measured(Traffic latest, String in, String out) {}

  ClientsPresenter(DesktopPorts ports) {
    this.ports = ports;
  }

  /**
   * Takes what has happened, unless it was looked at a moment ago.
   *
   * @param nowNs a clock
   * @return whether there may be something new to show
   */
  boolean look(long nowNs) {
    if (looked && nowNs - lookedNs < LOOK_NS) {
      return false;
    }
    looked = true;
    lookedNs = nowNs;
    if (recording && trace.isEmpty()) {
      record();
    }
    clients = rows(nowNs);
    filtered();
    return true;
  }

  private void record() {
    LiveTrace begun = trace.orElseGet(() -> new LiveTrace(ports::robotTimeS));
    trace = Optional.of(begun);
    ports.tap(Optional.of(begun.tap()));
  }

  /** Keeps what comes from now on, or no longer; what is kept stays. */
  void setRecording(boolean wanted) {
    recording = wanted;
    if (wanted) {
      record();
    } else {
      ports.tap(Optional.empty());
      trace.ifPresent(LiveTrace::pause);
    }
  }

  boolean recording() {
    return recording;
  }

  MessageFilter filter() {
    return filter;
  }

  void setFilter(MessageFilter wanted) {
    filter = wanted;
    newest = -1;
    filtered();
  }

  /** Forgets the messages. */
  void clear() {
    trace.ifPresent(LiveTrace::clear);
    filtered();
  }

  private void filtered() {
    long now = trace.map(LiveTrace::newest).orElse(0L);
    if (now != newest) {
      newest = now;
      messages =
          trace.map(each -> each.messages(filter.streamed())).orElse(List.of()).stream()
              .filter(filter::wants)
              .toList();
    }
  }

  /** The messages that the filter wants, the oldest first. */
  List<WireMessage> messages() {
    return messages;
  }

  /** The clients that are connected. */
  List<ClientRow> clients() {
    return clients;
  }

  /**
   * What clients did to the present controller, in the order of time.
   *
   * @param nowNs a clock
   */
  List<ClientMark> marks(long nowNs) {
    if (!marked || nowNs - markedNs >= LOOK_NS) {
      marked = true;
      markedNs = nowNs;
      marks = trace.map(each -> marks(each.messages(false), ports.robotTimeS())).orElse(List.of());
    }
    return marks;
  }

  /** Of messages, those with an effect; time begins again with another controller. */
  static List<ClientMark> marks(List<WireMessage> messages, double nowS) {
    List<ClientMark> marks = new ArrayList<>();
    double laterS = nowS;
    for (WireMessage each : messages.reversed()) {
      if (each.robotTimeS() > laterS + CLOCKS_S) {
        break;
      }
      laterS = each.robotTimeS();
      each.reading()
          .effect()
          .ifPresent(
              effect ->
                  marks.add(
                      new ClientMark(
                          each.robotTimeS(),
                          each.number(),
                          text(
                              "clientMark",
                              each.peers().port(),
                              each.peers().client(),
                              MessageWords.shown(each.reading(), effect)))));
    }
    return marks.reversed();
  }

  /** One line about it all. */
  String summary() {
    if (!(ports.state() instanceof PortsState.Open)) {
      return text("thePortsAreClosed");
    }
    long lost = trace.map(LiveTrace::leftOut).orElse(0L);
    List<String> parts = new ArrayList<>();
    if (clients.isEmpty()) {
      parts.add(text("nobodyIsConnected"));
    }
    parts.add(text(messages.size() == 1 ? "oneMessage" : "messageCount", messages.size()));
    if (!recording) {
      parts.add(text("paused"));
    }
    if (lost > 0) {
      parts.add(text("leftOut", lost));
    }
    return Messages.joined(parts);
  }

  private List<ClientRow> rows(long nowNs) {
    List<Connection> connections =
        ports.state() instanceof PortsState.Open open
            ? open.ports().stream().flatMap(each -> each.port().connections().stream()).toList()
            : List.of();
    traffic.keySet().retainAll(connections);
    Map<Peers, MessageCounts> counts = trace.map(LiveTrace::counts).orElse(Map.of());
    List<ClientRow> rows = new ArrayList<>();
    for (Connection each : connections) {
      Peers peers = new Peers(each.portName(), each.local(), each.peer());
      rows.add(row(each, peers, counts.getOrDefault(peers, MessageCounts.NONE), nowNs));
    }
    return List.copyOf(rows);
  }

  private ClientRow row(Connection connection, Peers peers, MessageCounts counts, long nowNs) {
    Traffic now =
        new Traffic(
            nowNs, connection.receivedBytes(), connection.sentBytes(), counts.in(), counts.out());
    Measured measured = traffic.computeIfAbsent(connection, absent -> new Measured(now, "", ""));
    if (nowNs - measured.latest().atNs() >= RATE_NS) {
      measured = new Measured(now, now.in(measured.latest()), now.out(measured.latest()));
      traffic.put(connection, measured);
    }
    Optional<Terms> terms = connection.terms();
    return new ClientRow(
        peers,
        age(connection.age().toSeconds()),
        measured.in(),
        measured.out(),
        terms.map(ClientsPresenter::data).orElse(""),
        waiting(connection),
        terms.map(Terms::reads).orElse(List.of()),
        terms.map(Terms::writes).orElse(List.of()));
  }

  private static String age(long seconds) {
    return seconds < 60
        ? seconds + " s"
        : seconds < 3600 ? seconds / 60 + " min" : seconds / 3600 + " h";
  }

  private static String data(Terms terms) {
    int count = terms.reads().size();
    if (count == 0) {
      return "";
    }
    String fields = text(count == 1 ? "oneField" : "fieldCount", count);
    double rateHz = terms.rateHz();
    return rateHz == 0
        ? Messages.joined(List.of(fields, text("paused")))
        : String.format(Locale.ROOT, rateHz < 10 ? "%.1f Hz, " : "%.0f Hz, ", rateHz) + fields;
  }

  private static String waiting(Connection connection) {
    List<String> words = new ArrayList<>();
    if (connection.unsentBytes() > 0) {
      words.add(Traffic.size(connection.unsentBytes()));
    }
    if (connection.dropped() > 0) {
      words.add(text("leftOut", connection.dropped()));
    }
    return Messages.joined(words);
  }
}
