package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.service.PortWishes;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.session.RobotSession;
import org.pendant.protocols.trace.Peers;
import org.pendant.protocols.trace.WireMessage;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Reading;

@Timeout(60)
final class ClientsPresenterTest {
  private static final int DASHBOARD = 29_999;

  @TempDir Path folder;

  private RobotSession session;
  private DesktopPorts ports;
  private ClientsPresenter presenter;
  private PortWishes wishes;
  private long nowNs;

  @BeforeEach
  void start() {
    session = RobotSession.start(ControllerOptions.headless());
    ports = new DesktopPorts(session, folder, visit -> {});
    presenter = new ClientsPresenter(ports);
    presenter.look(nowNs);
    wishes = FreePorts.wishes(folder);
    ports.want(Optional.of(wishes));
  }

  @AfterEach
  void end() {
    session.close();
  }

  /** Looks a second later, again and again. */
  private void await(BooleanSupplier condition) {
    while (!condition.getAsBoolean()) {
      nowNs += TimeUnit.SECONDS.toNanos(1);
      presenter.look(nowNs);
      Thread.onSpinWait();
    }
  }

  private List<String> shown() {
    return presenter.messages().stream()
        .map(each -> each.direction().word() + " " + each.reading().summary())
        .toList();
  }

  private Socket client() throws IOException {
    return new Socket(FreePorts.address(wishes), DASHBOARD + wishes.offset());
  }

  private static void talk(Socket client, String... lines) throws IOException {
    BufferedReader in =
        new BufferedReader(
            new InputStreamReader(client.getInputStream(), StandardCharsets.ISO_8859_1));
    in.readLine();
    for (String line : lines) {
      client.getOutputStream().write((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
      in.readLine();
    }
  }

  @Test
  void showsClientsAndTheirMessages() throws IOException {
    assertEquals("Nobody is connected, 0 messages", looked());
    try (Socket client = client()) {
      talk(client, "robotmode");
      await(() -> shown().size() == 4);
      assertEquals(
          List.of(
              "in connected",
              "out Connected: Universal Robots Dashboard Server",
              "in robotmode",
              "out Robotmode: RUNNING"),
          shown());
      ClientRow row = presenter.clients().getFirst();
      assertEquals("Dashboard", row.peers().port());
      assertEquals("127.0.0.1:" + client.getLocalPort(), row.peers().client());
    }
    await(() -> presenter.clients().isEmpty());
  }

  private String looked() {
    nowNs += TimeUnit.SECONDS.toNanos(1);
    assertTrue(presenter.look(nowNs));
    return presenter.summary();
  }

  @Test
  void filtersByTextDirectionAndEffect() throws IOException {
    try (Socket client = client()) {
      talk(client, "robotmode", "power on");
      await(() -> shown().size() == 6);
    }
    presenter.setFilter(MessageFilter.USUAL.withText("ROBOTMODE"));
    assertEquals(List.of("in robotmode", "out Robotmode: RUNNING"), shown());
    presenter.setFilter(
        MessageFilter.USUAL.withText("robotmode").withDirection(Optional.of(Direction.OUT)));
    assertEquals(List.of("out Robotmode: RUNNING"), shown());
    presenter.setFilter(MessageFilter.USUAL.withEffects(true));
    assertEquals(List.of("in power on"), shown());
  }

  @Test
  void keepsNothingMoreWhilePausedAndForgetsWhenCleared() throws IOException {
    try (Socket client = client()) {
      talk(client, "robotmode");
      await(() -> shown().size() == 4);
      presenter.setRecording(false);
      assertTrue(presenter.summary().endsWith("messages, paused"), presenter.summary());
    }
    presenter.clear();
    assertEquals(List.of(), shown());
  }

  private static WireMessage message(long number, double robotTimeS, String line) {
    InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), 29_999);
    Reading reading = Reading.of("line", line);
    return new WireMessage(
        number,
        new Peers("Dashboard", address, address),
        Direction.IN,
        0,
        robotTimeS,
        line.equals("running") ? reading : reading.doing(line),
        ByteBuffer.allocate(0));
  }

  private static List<String> marks(double nowS, WireMessage... messages) {
    return ClientsPresenter.marks(List.of(messages), nowS).stream()
        .map(each -> each.timeS() + " " + each.text().substring(each.text().lastIndexOf(' ') + 1))
        .toList();
  }

  @Test
  void marksWhatDidSomethingToThePresentController() {
    WireMessage stop = message(1, 7, "stop");
    WireMessage play = message(2, 1, "play");
    WireMessage asks = message(3, 2, "running");
    WireMessage pause = message(4, 3, "pause");
    assertEquals(List.of("1.0 play", "3.0 pause"), marks(4, stop, play, asks, pause));
    assertEquals(List.of(), marks(0.5, stop));
  }

  @Test
  void looksAFewTimesASecondOnly() {
    presenter.look(nowNs += TimeUnit.SECONDS.toNanos(1));
    assertFalse(presenter.look(nowNs + TimeUnit.MILLISECONDS.toNanos(100)));
    assertTrue(presenter.look(nowNs + TimeUnit.MILLISECONDS.toNanos(300)));
  }
}
