package org.pendant.protocols.primary;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.Protocol;
import org.pendant.protocols.net.Session;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.script.ScriptDesk;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.Server;

/** Ports 30001 and 30002, which take scripts, and their read-only twins 30011 and 30012. */
public final class PrimaryServer implements Server {
  private static final int PRIMARY = 30001;
  private static final int SECONDARY = 30002;
  private static final int PRIMARY_READ_ONLY = 30011;
  private static final int SECONDARY_READ_ONLY = 30012;

  private final Outside outside;
  private final PrimaryFeed feed;
  private final Consumer<ControllerState> frames;
  private final List<TcpPort> ports = new ArrayList<>();

  private PrimaryServer(Outside outside, PrimaryFeed feed) {
    this.outside = outside;
    this.feed = feed;
    frames = feed::frame;
  }

  /**
   * Opens the four ports.
   *
   * @param desk runs what clients send
   * @throws IOException if a port cannot be had; the message names it, and none is open then
   */
  public static PrimaryServer open(Outside outside, PortNumbers numbers, ScriptDesk desk)
      throws IOException {
    PrimaryFeed feed = new PrimaryFeed(outside.controller());
    PrimaryServer server = new PrimaryServer(outside, feed);
    BiFunction<Connection, Runnable, Session> ignore =
        (connection, left) -> ScriptDesk.readOnly(left);
    try {
      server.listen(numbers, "Primary", PRIMARY, feed::addPrimary, desk::session);
      server.listen(numbers, "Secondary", SECONDARY, feed::addSecondary, desk::session);
      server.listen(numbers, "Primary read-only", PRIMARY_READ_ONLY, feed::addPrimary, ignore);
      server.listen(
          numbers, "Secondary read-only", SECONDARY_READ_ONLY, feed::addSecondary, ignore);
    } catch (IOException e) {
      server.close();
      throw e;
    }
    outside.frames().add(server.frames);
    desk.onTrouble(feed::tell);
    outside.remote().onLocal(server::disconnectWriters);
    return server;
  }

  private void listen(
      PortNumbers numbers,
      String name,
      int number,
      Consumer<Connection> greeting,
      BiFunction<Connection, Runnable, Session> input)
      throws IOException {
    Protocol protocol =
        connection -> {
          greeting.accept(connection);
          return input.apply(connection, () -> feed.remove(connection));
        };
    ports.add(TcpPort.open(numbers.listening(name, number), protocol, outside.log()));
  }

  /** Who could control the robot has to connect again. */
  private void disconnectWriters() {
    ports.get(0).disconnectAll();
    ports.get(1).disconnectAll();
  }

  @Override
  public List<TcpPort> ports() {
    return List.copyOf(ports);
  }

  @Override
  public void close() {
    outside.frames().remove(frames);
    Server.super.close();
  }
}
