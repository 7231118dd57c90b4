package org.pendant.protocols.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.egress.HostPolicy;
import org.pendant.protocols.egress.Traced;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.Listening;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.Session;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.LineDissector;

class WireTraceTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final BlockingQueue<Connection> connected = new LinkedBlockingQueue<>();
  private final List<String> trouble = new ArrayList<>();
  private final TcpPort port = open();

  private TcpPort open() {
    try {
      return TcpPort.open(
          new Listening("Echo", LOOPBACK, 0)
              .readBy(() -> new LineDissector(line -> Optional.of(line).filter("go"::equals))),
          this::echo,
          new PeerLog((level, text) -> {}));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private Session echo(Connection connection) {
    connected.add(connection);
    return bytes -> {
      byte[] copy = new byte[bytes.remaining()];
      bytes.get(copy);
      connection.send(copy);
    };
  }

  @AfterEach
  void close() {
    port.close();
  }

  private void talk(String... lines) throws IOException {
    try (Socket client = new Socket(LOOPBACK, port.number())) {
      BufferedReader in =
          new BufferedReader(
              new InputStreamReader(client.getInputStream(), StandardCharsets.ISO_8859_1));
      for (String line : lines) {
        client.getOutputStream().write((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
        assertEquals(line, in.readLine());
      }
    }
  }

  private List<String> linesOf(String... talk) throws IOException {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    try (WireTrace trace = TraceFile.begin(Path.of("t.jsonl"), file, () -> 12.5, trouble::add)) {
      port.tap(Optional.of(trace));
      talk(talk);
    }
    assertEquals(List.of(), trouble);
    return file.toString(StandardCharsets.UTF_8).lines().toList();
  }

  @Test
  void writesALineForEachMessageOfBothDirections() throws Exception {
    List<String> lines = linesOf("hello", "go");
    assertTrue(lines.get(0).contains("\"type\":\"connected\""), lines.get(0));
    String asked = lines.get(1);
    assertTrue(asked.contains("\"robot_s\":12.5"), asked);
    assertTrue(asked.contains("\"port\":\"Echo\",\"number\":" + port.number()), asked);
    assertTrue(asked.contains("\"direction\":\"in\",\"type\":\"line\""), asked);
    assertTrue(asked.contains("\"fields\":{\"text\":\"hello\"}"), asked);
    assertTrue(asked.endsWith("\"length\":6,\"bytes\":\"68656c6c6f0a\"}"), asked);
    assertTrue(lines.get(2).contains("\"direction\":\"out\",\"type\":\"answer\""), lines.get(2));
  }

  @Test
  void saysWhatAMessageDoes() throws Exception {
    List<String> lines = linesOf("go");
    assertTrue(lines.get(1).contains("\"effect\":\"go\""), lines.get(1));
  }

  @Test
  void hearsWhatProgramsConnectToWithTheirsAsWhatGoesOut() throws Exception {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    try (WireTrace trace = TraceFile.begin(Path.of("t.jsonl"), file, () -> 0, trouble::add)) {
      Traced traced = new Traced("Script socket", Dissector::raw, () -> Optional.of(trace));
      try (Socket socket =
          new HostPolicy(AllowedHosts.ANY)
              .with(traced)
              .connect("127.0.0.1", port.number(), 10_000)) {
        socket.getOutputStream().write(new byte[] {'h', 'i', '\n'});
        assertEquals('h', socket.getInputStream().read());
      }
    }
    List<String> lines = file.toString(StandardCharsets.UTF_8).lines().toList();
    assertEquals(4, lines.size(), lines::toString);
    assertTrue(lines.get(0).contains("\"direction\":\"out\",\"type\":\"connected\""), lines.get(0));
    assertTrue(lines.get(1).contains("\"direction\":\"out\",\"type\":\"text\""), lines.get(1));
    assertTrue(lines.get(1).contains("\"client\":\"127.0.0.1:" + port.number()), lines.get(1));
    assertTrue(lines.get(2).contains("\"direction\":\"in\",\"type\":\"text\""), lines.get(2));
    assertTrue(lines.get(3).contains("\"type\":\"closed\""), lines.get(3));
  }

  @Test
  void hearsNothingWithoutATap() throws Exception {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    try (WireTrace trace = TraceFile.begin(Path.of("t.jsonl"), file, () -> 0, trouble::add)) {
      port.tap(Optional.of(trace));
      port.tap(Optional.empty());
      talk("hello");
    }
    assertEquals(0, file.size());
  }

  /** A sink that stands still until it is let go. */
  private static final class Slow implements TraceSink {
    private final CountDownLatch go = new CountDownLatch(1);
    private long leftOut;
    private int taken;

    @Override
    public void take(WireEvent event) throws IOException {
      try {
        go.await();
      } catch (InterruptedException e) {
        throw new IOException(e);
      }
      taken++;
    }

    @Override
    public void leftOut(long count, long epochUs) {
      leftOut += count;
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}
  }

  @Test
  void leavesOutAndCountsWhatFindsNoRoom() throws Exception {
    talk("hello");
    Connection connection = connected.take();
    Slow sink = new Slow();
    try (WireTrace trace =
        new WireTrace(() -> 0, InstantSource.fixed(Instant.EPOCH), sink, trouble::add).start()) {
      byte[] large = new byte[(int) WireTrace.MAX_WAITING_BYTES / 4];
      for (int i = 0; i < 10; i++) {
        trace.sent(connection, (long) i * large.length, large);
      }
      assertEquals(6, trace.leftOut());
      sink.go.countDown();
    }
    assertEquals(6, sink.leftOut);
    assertEquals(4, sink.taken);
  }

  @Test
  void endsAndSaysWhyWhenItCannotWrite() throws Exception {
    talk("hello");
    Connection connection = connected.take();
    OutputStream full =
        new OutputStream() {
          @Override
          public void write(int one) throws IOException {
            throw new IOException("no space left");
          }
        };
    JsonSink sink = new JsonSink(new JsonWriter(full));
    try (WireTrace trace =
        new WireTrace(() -> 0, InstantSource.system(), sink, trouble::add).start()) {
      trace.received(connection, 0, ByteBuffer.wrap(new byte[] {65, 10}));
    }
    assertEquals(List.of("no space left"), trouble);
  }
}
