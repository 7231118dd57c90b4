package org.pendant.protocols.primary;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.Protocol;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.script.ScriptDesk;
import org.pendant.protocols.serve.MissingPort;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.PortOpening;
import org.pendant.protocols.serve.Server;

/** Ports 30001 and 30002, which take scripts, and their read-only twins 30011 and 30012. */
public final class PrimaryServer implements Server {
  /** Where most clients send their scripts. */
  public static final int PRIMARY = 30001;

  /** Where clients find the same without the messages of the primary port. */
  public static final int SECONDARY = 30002;

  private static final int PRIMARY_READ_ONLY = 30011;
  private static final int SECONDARY_READ_ONLY = 30012;

  private final Outside outside;
  private final PrimaryFeed feed;
  private final Consumer<ControllerState> frames;
  private final List<TcpPort> writable = new ArrayList<>();
  private final List<TcpPort> readOnly = new ArrayList<>();
  private final PortOpening opening = new PortOpening();

  private PrimaryServer(Outside outside, PrimaryFeed feed) {
    this.outside = outside;
    this.feed = feed;
    frames = feed::frame;
  }

  /**
   * Opens those of the four ports that can be had.
   *
   * @param desk runs what clients send
   */
  public static PrimaryServer open(Outside outside, PortNumbers numbers, ScriptDesk desk) {
    PrimaryFeed feed = new PrimaryFeed(outside.controller());
    PrimaryServer server = new PrimaryServer(outside, feed);
    server.take(numbers, "Primary", PRIMARY, feed::addPrimary, desk);
    server.take(numbers, "Secondary", SECONDARY, feed::addSecondary, desk);
    server.showOnly(numbers, "Primary read-only", PRIMARY_READ_ONLY, feed::addPrimary);
    server.showOnly(numbers, "Secondary read-only", SECONDARY_READ_ONLY, feed::addSecondary);
    outside.frames().add(server.frames);
    desk.onTrouble(feed::tell);
    outside.remote().onLocal(() -> server.writable.forEach(TcpPort::disconnectAll));
    return server;
  }

  private void take(
      PortNumbers numbers,
      String name,
      int number,
      Consumer<Connection> greeting,
      ScriptDesk desk) {
    Protocol protocol =
        connection -> {
          greeting.accept(connection);
          return desk.session(connection, () -> feed.remove(connection));
        };
    listen(numbers, name, number, protocol, writable);
  }

  private void showOnly(
      PortNumbers numbers, String name, int number, Consumer<Connection> greeting) {
    Protocol protocol =
        connection -> {
          greeting.accept(connection);
          return ScriptDesk.readOnly(() -> feed.remove(connection));
        };
    listen(numbers, name, number, protocol, readOnly);
  }

  private void listen(
      PortNumbers numbers, String name, int number, Protocol protocol, List<TcpPort> ports) {
    opening.attempt(
        number,
        () -> ports.add(TcpPort.open(numbers.listening(name, number), protocol, outside.log())));
  }

  @Override
  public List<TcpPort> ports() {
    return Stream.concat(writable.stream(), readOnly.stream()).toList();
  }

  @Override
  public List<MissingPort> missing() {
    return opening.missing();
  }

  @Override
  public void close() {
    outside.frames().remove(frames);
    Server.super.close();
  }
}
