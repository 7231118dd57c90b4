package org.pendant.protocols.xmlrpc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.UnaryOperator;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.protocols.ClosedPort;
import org.pendant.protocols.Peer;
import org.pendant.protocols.ScriptRun;
import org.pendant.protocols.egress.AllowedHosts;

@Timeout(60)
class XmlRpcProgramTest {
  private final BlockingQueue<String> asked = new LinkedBlockingQueue<>();

  /** A server that keeps its connections; what it answers depends on the body of the call. */
  private Peer server(UnaryOperator<String> answer) {
    return Peer.that(
        client -> {
          for (String body = Xml.request(client); !body.isEmpty(); body = Xml.request(client)) {
            asked.add(body);
            Xml.say(client, answer.apply(body));
          }
        });
  }

  private static Peer raw(Peer.Conversation afterTheCall) {
    return Peer.that(
        client -> {
          if (!Xml.request(client).isEmpty()) {
            afterTheCall.with(client);
          }
        });
  }

  private static String handle(Peer peer) {
    return "  global h = rpc_factory(\"xmlrpc\", \"http://127.0.0.1:" + peer.port() + "/RPC2\")\n";
  }

  private static List<String> says(Peer peer, String lines) throws InterruptedException {
    try (ScriptRun script = new ScriptRun()) {
      List<String> said = script.run(handle(peer) + lines);
      assertEquals(List.of(), script.reported());
      return said;
    }
  }

  private static String fails(Peer peer, String lines) throws InterruptedException {
    try (ScriptRun script = new ScriptRun()) {
      script.run(handle(peer) + lines);
      String report = script.reported().getLast();
      return report.substring(report.indexOf(": ") + 2);
    }
  }

  /** What {@code textmsg} makes of a value that the server answers. */
  private String received(String xml) throws Exception {
    try (Peer peer = server(body -> Xml.http(Xml.value(xml)))) {
      return says(peer, "  textmsg(h.get())\n").getFirst();
    }
  }

  @Test
  void receivesEveryType() throws Exception {
    assertEquals("-7", received("<int>-7</int>"));
    assertEquals("8", received("<i4>8</i4>"));
    assertEquals("9", received("<i8>9</i8>"));
    assertEquals("2.5", received("<double>2.5</double>"));
    assertEquals("True", received("<boolean>1</boolean>"));
    assertEquals("a<b", received("<string>a&lt;b</string>"));
    assertEquals("plain", received("plain"));
    assertEquals("\u00c3\u00a9", received("<string>\u00e9</string>"));
    assertEquals("None", received("<nil/>"));
    assertEquals(
        "[1, 2.5]",
        received(
            "<array><data><value><int>1</int></value><value><double>2.5</double></value>"
                + "</data></array>"));
    assertEquals("[]", received("<array><data></data></array>"));
    assertEquals(
        "{b = 1, a = \"x\"}", received(Xml.struct("b", "<int>1</int>", "a", "<string>x</string>")));
    assertEquals(
        "{s = {t = [True]}}",
        received(
            Xml.struct(
                "s",
                Xml.struct(
                    "t", "<array><data><value><boolean>1</boolean></value></data></array>"))));
  }

  @Test
  void aStructOfXyzAndRotationIsAPose() throws Exception {
    assertEquals(
        "p[1, 2, 3, 4, 5, 6]",
        received(
            Xml.struct(
                "rx", "<double>4</double>",
                "ry", "<double>5</double>",
                "rz", "<int>6</int>",
                "x", "<double>1</double>",
                "y", "<double>2</double>",
                "z", "<double>3</double>")));
  }

  @Test
  void sendsEveryType() throws Exception {
    try (Peer peer = server(body -> Xml.http(Xml.value("<boolean>1</boolean>")))) {
      says(
          peer,
          """
            h.examples.put(-1, 1e-7, True, "a<\u00c3\u00a9", p[1,2,3,4,5,6], [1.5, 2], [[1,2],[3,4]])
            h.put(struct(b = 1, a = [True]))
          """);
    }
    String sent = asked.take();
    assertTrue(sent.contains("<methodName>examples.put</methodName>"), sent);
    for (String part :
        List.of(
            "<i4>-1</i4>",
            "<double>0.00000010</double>",
            "<boolean>1</boolean>",
            "a&lt;\u00e9",
            "<member><name>x</name><value><double>1.0</double></value></member><member><name>y<",
            "<data><value><double>1.5</double></value><value><double>2.0</double></value></data>",
            "<data><value><array><data><value><i4>1</i4>")) {
      assertTrue(sent.contains(part), () -> part + " in " + sent);
    }
    String struct = asked.take();
    assertTrue(
        struct.contains("<struct><member><name>b</name><value><i4>1</i4></value></member>"),
        struct);
  }

  @Test
  void refusesToSendWhatXmlRpcDoesNotHave() throws Exception {
    try (Peer peer = server(body -> Xml.http(Xml.value("1")))) {
      assertEquals("put: argument 2: None cannot be sent", fails(peer, "  h.put(1, None)\n"));
      assertEquals("put: argument 1: an rpc handle cannot be sent", fails(peer, "  h.put(h)\n"));
    }
  }

  @Test
  void oneConnectionCarriesAllCallsUntilItIsClosed() throws Exception {
    try (Peer peer = server(body -> Xml.http(Xml.value("x")))) {
      says(peer, "  h.a()\n  h.b()\n  h.c()\n");
      // the first was only to see whether the server is there
      assertEquals(2, peer.clients());
      says(peer, "  h.a()\n  h.closeXMLRPCClientConnection()\n  h.b()\n");
      assertEquals(5, peer.clients());
    }
  }

  @Test
  void aServerThatClosesAfterEachAnswerIsCalledAgain() throws Exception {
    try (Peer peer = raw(client -> Xml.say(client, Xml.http(Xml.value("<int>1</int>"))))) {
      assertEquals(List.of("1", "1"), says(peer, "  textmsg(h.a())\n  textmsg(h.b())\n"));
    }
  }

  @Test
  void readsAnswersInChunksAndWithoutALength() throws Exception {
    String body = Xml.value("<int>5</int>");
    String chunked =
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n5;x=y\r\n"
            + body.substring(0, 5)
            + "\r\n"
            + Integer.toHexString(body.length() - 5)
            + "\r\n"
            + body.substring(5)
            + "\r\n0\r\n\r\n";
    try (Peer peer = server(request -> chunked)) {
      assertEquals(List.of("5", "5"), says(peer, "  textmsg(h.a())\n  textmsg(h.b())\n"));
    }
    try (Peer peer = raw(client -> Xml.say(client, "HTTP/1.0 200 OK\n\n" + body))) {
      assertEquals(List.of("5"), says(peer, "  textmsg(h.a())\n"));
    }
  }

  @Test
  void readsAnAnswerThatComesByteByByte() throws Exception {
    Peer.Conversation bytes =
        client -> {
          for (byte next : Xml.http(Xml.value("<int>5</int>")).getBytes(StandardCharsets.UTF_8)) {
            client.getOutputStream().write(next);
          }
        };
    try (Peer peer = raw(bytes)) {
      assertEquals(List.of("5"), says(peer, "  textmsg(h.a())\n"));
    }
  }

  @Test
  void aFaultEndsTheProgramAndIsQuoted() throws Exception {
    try (Peer peer = server(body -> Xml.http(Xml.fault(4, "no camera\nhere", "")))) {
      assertEquals("look: fault 4: no camera here", fails(peer, "  h.look()\n"));
    }
  }

  /** CVE-2019-17570: the library would make an object of it. */
  @Test
  void theCauseOfAFaultIsNotLookedAt() throws Exception {
    String cause =
        "<member><name>faultCause</name><value><base64>rO0ABXNyABFqYXZhLmxhbmcuQm9vbGVhbg==</base64>"
            + "</value></member>";
    try (Peer peer = server(body -> Xml.http(Xml.fault(4, "no", cause)))) {
      assertEquals("look: fault 4: no", fails(peer, "  h.look()\n"));
    }
  }

  /** CVE-2016-5002: the library would fetch it. */
  @Test
  void aDocumentTypeIsRefused() throws Exception {
    try (Peer other = Peer.that(client -> asked.add("fetched"));
        Peer peer =
            server(
                body ->
                    Xml.http(
                        "<!DOCTYPE methodResponse SYSTEM \"http://127.0.0.1:"
                            + other.port()
                            + "/x.dtd\">"
                            + Xml.value("1")))) {
      String failure = fails(peer, "  h.look()\n");
      assertTrue(failure.startsWith("look: the answer is not XML-RPC: DOCTYPE"), failure);
      assertEquals(0, other.clients());
    }
  }

  /** CVE-2016-5003: the library's extension would make an object of it. */
  @Test
  void aSerialisedObjectIsRefused() throws Exception {
    for (String answer :
        List.of(
            Xml.value(
                "<ex:serializable xmlns:ex=\"http://ws.apache.org/xmlrpc/namespaces/extensions\">"
                    + "rO0ABXNyABFqYXZhLmxhbmcuQm9vbGVhbg==</ex:serializable>"),
            Xml.value("<serializable>rO0ABXNyABFqYXZhLmxhbmcuQm9vbGVhbg==</serializable>"))) {
      refuses("look: the answer is not XML-RPC: ", Xml.http(answer));
    }
  }

  /** Nothing is unpacked, so nothing can grow. */
  @Test
  void aPackedAnswerIsRefused() throws Exception {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(packed)) {
      out.write(Xml.value(" ".repeat(1_000_000)).getBytes(StandardCharsets.ISO_8859_1));
    }
    refuses(
        "look: the answer is not XML-RPC: ",
        "HTTP/1.1 200 OK\r\nContent-Encoding: gzip\r\nContent-Length: "
            + packed.size()
            + "\r\n\r\n"
            + packed.toString(StandardCharsets.ISO_8859_1));
  }

  @Test
  void anUnknownEncodingIsNamed() throws Exception {
    refuses(
        "look: the answer is in the encoding utf-7, which is not known: use UTF-8",
        Xml.http(
            Xml.value("1")
                .replaceFirst("^(<\\?xml[^>]*>)?", "<?xml version=\"1.0\" encoding=\"utf-7\"?>")));
  }

  @Test
  void whatIsNoAnswerEndsTheProgram() throws Exception {
    refuses("look: the answer is not HTTP", "hello\r\n\r\n");
    refuses("look: HTTP status 404 Not Found", "HTTP/1.1 404 Not Found\r\n\r\n");
    refuses("look: the answer is not XML-RPC: ", Xml.http("<html></html>"));
    refuses("look: the answer is not XML-RPC: ", Xml.http("garbage"));
    refuses("look: the answer is not XML-RPC: ", Xml.http(Xml.value("<int>x</int>")));
    refuses("look: the answer is not XML-RPC: ", Xml.http(Xml.value("<date>x</date>")));
    refuses(
        "look: the answer is of a type that scripts do not have: base64",
        Xml.http(Xml.value("<base64>AAAA</base64>")));
    refuses("look: the answer 3000000000 does not", Xml.http(Xml.value("<i8>3000000000</i8>")));
    refuses(
        "look: list: element 1 ",
        Xml.http(
            Xml.value("<array><data><value><int>1</int></value><value>x</value></data></array>")));
    refuses(
        "look: the length of the answer is \"-1\"",
        "HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\n");
    refuses(
        "look: the answer has more than 4194304 bytes",
        "HTTP/1.1 200 OK\r\nContent-Length: 4194305\r\n\r\n");
    refuses("look: a line of the answer has more than 8192", "HTTP/1.1 200 " + "x".repeat(9000));
    refuses(
        "look: the server closed the connection in the middle of its answer",
        "HTTP/1.1 200 OK\r\nContent-Length: 100\r\n\r\nshort");
    refuses(
        "look: the answer is not XML-RPC: more than 90 elements within each other",
        Xml.http(Xml.value("<array><data><value>".repeat(100_000))));
    refuses("look: the server closed the connection without an answer", "");
  }

  private static void refuses(String message, String answer) throws Exception {
    try (Peer peer = raw(client -> Xml.say(client, answer))) {
      String failure = fails(peer, "  h.look()\n");
      assertTrue(failure.startsWith(message), failure);
    }
  }

  @Test
  void anAbsentServerEndsTheProgram() throws Exception {
    try (ClosedPort closed = new ClosedPort();
        ScriptRun script = new ScriptRun()) {
      int port = closed.number();
      script.run("  rpc_factory(\"xmlrpc\", \"http://127.0.0.1:" + port + "/RPC2\")\n");
      assertTrue(
          script
              .reported()
              .getLast()
              .endsWith("rpc_factory: http://127.0.0.1:" + port + "/RPC2: connection refused"),
          script.reported()::toString);
    }
  }

  @Test
  void aServerThatIsNotAllowedIsNotReached() throws Exception {
    try (Peer peer = server(body -> "");
        ScriptRun script = new ScriptRun(AllowedHosts.parse("none"))) {
      script.run(handle(peer));
      assertTrue(
          script.reported().getLast().endsWith("/RPC2: not among the allowed hosts"),
          script.reported()::toString);
      assertEquals(0, peer.clients());
    }
  }

  @Test
  void refusesWhatIsNoAddress() throws Exception {
    for (String url :
        List.of(
            "", "peer", "https://peer/", "http:///x", "http://a:0/", "peer:70000", "ftp://a:1")) {
      try (ScriptRun script = new ScriptRun()) {
        script.run("  rpc_factory(\"xmlrpc\", \"" + url + "\")\n");
        assertTrue(
            script
                .reported()
                .getLast()
                .endsWith("url is " + url + ", must be http://host:port/path or host:port"),
            script.reported()::toString);
      }
    }
  }

  @Test
  void callsByAStreamOfPackets() throws Exception {
    byte[] answer = PacketWire.packet(bytes(Xml.value("<string>a</string>")));
    Peer.Conversation stream =
        client -> {
          for (int i = 0; i < 2; i++) {
            asked.add(packet(client));
            OutputStream out = client.getOutputStream();
            out.write(bytes("\u001bNOP"));
            out.write(answer);
          }
        };
    try (Peer peer = Peer.that(stream);
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("a", "a"),
          script.run(
              "  h = rpc_factory(\"xmlrpc\", \"127.0.0.1:"
                  + peer.port()
                  + "\")\n  textmsg(h.one(\"x\"))\n  textmsg(h.two())\n"));
      assertTrue(asked.take().contains("<methodName>one</methodName>"));
      assertTrue(asked.take().contains("<methodName>two</methodName>"));
      assertEquals(1, peer.clients());
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  private static String packet(Socket client) throws IOException {
    StringBuilder packet = new StringBuilder();
    while (packet.indexOf("\u001bEND") < 0) {
      int next = client.getInputStream().read();
      if (next < 0) {
        throw new IOException("no packet");
      }
      packet.append((char) next);
    }
    return packet.toString();
  }

  @Test
  void escapesInPacketsStandForThemselves() {
    assertEquals(
        "\u001bPKTa\u001bESCb\u001bEND",
        new String(PacketWire.packet(bytes("a\u001bb")), StandardCharsets.ISO_8859_1));
  }

  @Test
  void callsOfSeveralThreadsTakeTurns() throws Exception {
    try (Peer peer = server(body -> Xml.http(Xml.value(body.contains("one") ? "1" : "2")))) {
      List<String> said =
          says(
              peer,
              """
                thread other():
                  i = 0
                  while i < 20:
                    assert(h.one() == "1")
                    i = i + 1
                  end
                end
                o = run other()
                k = 0
                while k < 20:
                  assert(h.two() == "2")
                  k = k + 1
                end
                join o
                textmsg("done")
              """);
      assertEquals(List.of("done"), said);
      assertEquals(2, peer.clients());
    }
  }

  @Test
  void aCallThatHangsEndsWithItsProgram() throws Exception {
    CountDownLatch called = new CountDownLatch(1);
    CountDownLatch gone = new CountDownLatch(1);
    Peer.Conversation hanging =
        client -> {
          called.countDown();
          client.getInputStream().transferTo(OutputStream.nullOutputStream());
          gone.countDown();
        };
    try (Peer peer = raw(hanging);
        ScriptRun script = new ScriptRun()) {
      script.start(handle(peer) + "  h.never()\n");
      while (called.getCount() > 0) {
        script.advance();
      }
      script.stop();
      gone.await();
    }
  }
}
