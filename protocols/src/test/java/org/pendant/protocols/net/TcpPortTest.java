package org.pendant.protocols.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.wire.Dissector;

class TcpPortTest {
  private static final int GIVE_UP_MS = 20_000;
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final BlockingQueue<String> logged = new LinkedBlockingQueue<>();
  private final BlockingQueue<Connection> connected = new LinkedBlockingQueue<>();
  private final BlockingQueue<String> visits = new LinkedBlockingQueue<>();
  private final CountDownLatch closed = new CountDownLatch(1);
  private final AtomicLong nowNs = new AtomicLong();
  private final TcpPort port = open(IdleLimits.NONE);

  /** Says hello, sends back what comes, and breaks off at a zero. */
  private Session echo(Connection connection) {
    connected.add(connection);
    connection.send(bytes("hello "));
    return new Session() {
      @Override
      public void received(ByteBuffer bytes) throws ProtocolException {
        byte[] text = new byte[bytes.remaining()];
        bytes.get(text);
        for (byte each : text) {
          if (each == 0) {
            throw new ProtocolException("a zero was found, must be text");
          }
        }
        connection.send(text);
      }

      @Override
      public void closed() {
        closed.countDown();
      }
    };
  }

  /** With two places, by a clock that stands still. */
  private TcpPort open(IdleLimits idle) {
    try {
      return TcpPort.open(
          new Listening("Echo", LOOPBACK, 0, 2, idle, Dissector::raw),
          this::echo,
          new PeerLog((level, text) -> logged.add(text), visits::add),
          nowNs::get);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private void pass(Duration time) {
    nowNs.addAndGet(time.toNanos());
  }

  private Socket connect() throws IOException {
    return connect(port);
  }

  private static Socket connect(TcpPort port) throws IOException {
    Socket socket = new Socket(LOOPBACK, port.number());
    socket.setSoTimeout(GIVE_UP_MS);
    return socket;
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  @AfterEach
  void close() {
    port.close();
  }

  @Test
  void greetsAndAnswers() throws Exception {
    try (Socket socket = connect()) {
      socket.getOutputStream().write(bytes("you"));
      assertArrayEquals(bytes("hello you"), socket.getInputStream().readNBytes(9));
    }
  }

  @Test
  void answersAPeerThatHasClosedItsSendingSide() throws Exception {
    try (Socket socket = connect()) {
      socket.getOutputStream().write(bytes("you"));
      socket.shutdownOutput();
      assertArrayEquals(bytes("hello you"), socket.getInputStream().readAllBytes());
      assertTrue(closed.await(GIVE_UP_MS, TimeUnit.MILLISECONDS));
    }
  }

  @Test
  void tellsWhichPeerHasComeAndLeft() throws Exception {
    String name;
    try (Socket socket = connect()) {
      name = "Echo client 127.0.0.1:" + socket.getLocalPort();
      assertEquals(name + " has connected", visits.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS));
    }
    assertEquals(name + " has left", visits.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS));
    assertTrue(logged.isEmpty());
  }

  @Test
  void disconnectsAPeerThatBreaksTheProtocolAndSaysSo() throws Exception {
    try (Socket socket = connect()) {
      socket.getOutputStream().write(0);
      assertArrayEquals(bytes("hello "), socket.getInputStream().readAllBytes());
      String line = logged.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      assertEquals(
          "Echo client 127.0.0.1:"
              + socket.getLocalPort()
              + " was disconnected: a zero was found, must be text",
          line);
    }
  }

  @Test
  void readsWhatAPeerHasSentThatIsGoneAlready() throws Exception {
    CountDownLatch gone = new CountDownLatch(1);
    BlockingQueue<String> received = new LinkedBlockingQueue<>();
    Protocol slow =
        connection -> {
          connected.add(connection);
          awaitUninterrupted(gone);
          return bytes -> received.add(StandardCharsets.ISO_8859_1.decode(bytes).toString());
        };
    try (TcpPort slowPort =
        TcpPort.open(new Listening("Slow", LOOPBACK, 0), slow, new PeerLog((level, text) -> {}))) {
      try (Socket socket = new Socket(LOOPBACK, slowPort.number())) {
        socket.getOutputStream().write(bytes("set_digital_out(1, True)"));
        socket.setSoLinger(true, 0);
      }
      Connection connection = connected.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(GIVE_UP_MS);
      while (connection.open()) {
        assertTrue(System.nanoTime() < end, "sending never fails");
        connection.stream(bytes("state"));
      }
      gone.countDown();
      assertEquals("set_digital_out(1, True)", received.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS));
    }
  }

  private static void awaitUninterrupted(CountDownLatch latch) {
    try {
      assertTrue(latch.await(GIVE_UP_MS, TimeUnit.MILLISECONDS));
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void takesOnlySoManyConnectionsThatAreInUse() throws Exception {
    try (Socket one = connect();
        Socket two = connect()) {
      say("you", one);
      say("two", two);
      try (Socket three = connect()) {
        assertEquals(-1, three.getInputStream().read());
        assertTrue(
            logged
                .poll(GIVE_UP_MS, TimeUnit.MILLISECONDS)
                .endsWith("was refused: 2 are connected already"));
      }
      one.getOutputStream().write(bytes("!"));
      assertEquals('!', one.getInputStream().read());
    }
  }

  private static void say(String word, Socket socket) throws IOException {
    socket.getOutputStream().write(bytes(word));
    assertArrayEquals(bytes("hello " + word), socket.getInputStream().readNBytes(9));
  }

  @Test
  void silentPeersShutNobodyOut() throws Exception {
    try (Socket one = connect();
        Socket two = connect()) {
      assertArrayEquals(bytes("hello "), one.getInputStream().readNBytes(6));
      assertArrayEquals(bytes("hello "), two.getInputStream().readNBytes(6));
      for (int i = 0; i < 20; i++) {
        try (Socket next = connect()) {
          say("you", next);
        }
        awaitNoMoreThan(1);
      }
      assertTrue(
          logged
              .poll(GIVE_UP_MS, TimeUnit.MILLISECONDS)
              .endsWith("was disconnected: it was silent, and others want its place"));
    }
  }

  private void awaitNoMoreThan(int connections) {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(GIVE_UP_MS);
    while (port.connections().size() > connections) {
      assertTrue(System.nanoTime() < end, "connections are not given back");
      Thread.onSpinWait();
    }
  }

  @Test
  void whoMustBeginAndDoesNotIsDisconnectedAfterAMinute() throws Exception {
    try (TcpPort strict = open(IdleLimits.peerBegins());
        Socket begins = connect(strict);
        Socket silent = connect(strict)) {
      say("you", begins);
      assertArrayEquals(bytes("hello "), silent.getInputStream().readNBytes(6));
      pass(Duration.ofSeconds(61));
      strict.look();
      assertEquals(-1, silent.getInputStream().read());
      assertTrue(
          logged
              .poll(GIVE_UP_MS, TimeUnit.MILLISECONDS)
              .endsWith("was disconnected: it has said nothing for 60 s"));
      begins.getOutputStream().write(bytes("!"));
      assertEquals('!', begins.getInputStream().read());
    }
  }

  @Test
  void whoReadsNothingForAMinuteIsDisconnected() throws Exception {
    try (Socket socket = connect()) {
      Connection connection = connected.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      fillUp(connection);
      pass(Duration.ofSeconds(59));
      port.look();
      assertTrue(connection.open());
      assertGivenUpAfter(Duration.ofSeconds(61));
      assertTrue(closed.await(GIVE_UP_MS, TimeUnit.MILLISECONDS));
      assertTrue(socket.isConnected());
    }
  }

  /** The system may take a little more for the peer after a while, which begins the time anew. */
  private void assertGivenUpAfter(Duration time) {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(GIVE_UP_MS);
    do {
      assertTrue(System.nanoTime() < end, "is never given up");
      pass(time);
      port.look();
    } while (!port.connections().isEmpty());
  }

  private static void fillUp(Connection connection) {
    byte[] message = new byte[1 << 16];
    while (connection.dropped() == 0) {
      connection.stream(message);
    }
  }

  @Test
  void whoHasSentAllAndReadsNothingIsDisconnectedAfterTenSeconds() throws Exception {
    try (Socket socket = connect()) {
      Connection connection = connected.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      fillUp(connection);
      socket.shutdownOutput();
      assertTrue(closed.await(GIVE_UP_MS, TimeUnit.MILLISECONDS));
      assertEquals(1, port.connections().size());
      assertGivenUpAfter(Duration.ofSeconds(11));
    }
  }

  @Test
  void whoIsToBeDisconnectedAfterSendingAndReadsNothingIsSoAfterTenSeconds() throws Exception {
    try (Socket socket = connect()) {
      Connection connection = connected.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      fillUp(connection);
      connection.closeAfterSending();
      assertGivenUpAfter(Duration.ofSeconds(11));
      assertTrue(closed.await(GIVE_UP_MS, TimeUnit.MILLISECONDS));
      assertTrue(socket.isConnected());
    }
  }

  @Test
  void aPeerThatReadsNothingMissesStreamsAndIsDisconnectedAfterAMegabyte() throws Exception {
    try (Socket socket = connect()) {
      Connection connection = connected.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      fillUp(connection);
      assertTrue(connection.open());
      byte[] message = new byte[1 << 16];
      for (int i = 0; connection.open(); i++) {
        assertTrue(i < 1000, "must have been disconnected");
        connection.send(message);
      }
      assertTrue(closed.await(GIVE_UP_MS, TimeUnit.MILLISECONDS));
      assertTrue(socket.isConnected());
    }
  }

  @Test
  void aPortThatIsTakenIsNamed() {
    IOException refused =
        assertThrows(
            IOException.class,
            () ->
                TcpPort.open(
                    new Listening("Other", LOOPBACK, port.number()),
                    this::echo,
                    new PeerLog((level, text) -> {})));
    assertTrue(
        refused
            .getMessage()
            .startsWith("Other: port " + port.number() + " of 127.0.0.1 cannot be had"),
        refused.getMessage());
  }

  @Test
  void closingEndsAllConnections() throws Exception {
    try (Socket socket = connect()) {
      socket.getInputStream().readNBytes(6);
      port.close();
      assertEquals(-1, socket.getInputStream().read());
      assertEquals(List.of(), List.copyOf(logged));
    }
  }

  @Test
  void aPortThatWasClosedCanBeHadAtOnce() throws Exception {
    int number = port.number();
    port.close();
    for (int i = 0; i < 20; i++) {
      TcpPort.open(
              new Listening("Echo", LOOPBACK, number),
              this::echo,
              new PeerLog((level, text) -> logged.add(text)))
          .close();
    }
    assertEquals(List.of(), List.copyOf(logged));
  }
}
