package org.pendant.protocols.socket;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.protocols.ClosedPort;
import org.pendant.protocols.Peer;
import org.pendant.protocols.ScriptRun;
import org.pendant.protocols.egress.AllowedHosts;

@Timeout(60)
class ScriptSocketsTest {
  private final BlockingQueue<String> heard = new LinkedBlockingQueue<>();

  private static String open(Peer peer) {
    return open(peer, "socket_0");
  }

  private static String open(Peer peer, String name) {
    return "  socket_open(\"127.0.0.1\", " + peer.port() + ", \"" + name + "\")\n";
  }

  private static void say(Socket client, String bytes) throws IOException {
    client.getOutputStream().write(bytes.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static void stay(Socket client) throws IOException {
    client.getInputStream().transferTo(OutputStream.nullOutputStream());
  }

  /** Reads until the script ends its side. */
  private void listen(Socket client) throws IOException {
    heard.add(new String(client.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1));
  }

  @Test
  void readsMessagesThatComeByteByByte() throws Exception {
    String message = "x>hello<\0\0\1\0(1, 2.5)\u00c8line\r\nvalue 7\n";
    Peer.Conversation bytes =
        client -> {
          OutputStream out = client.getOutputStream();
          for (byte next : message.getBytes(StandardCharsets.ISO_8859_1)) {
            out.write(next);
            out.flush();
            // the script asks for each, so that no two travel together
            client.getInputStream().read();
          }
          stay(client);
        };
    try (Peer peer = Peer.that(bytes);
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("hello", "[1, 256]", "[2, 1, 2.5]", "[1, 200]", "line", "7"),
          script.run(
              open(peer)
                  + """
                    thread asker():
                      while True:
                        socket_send_byte(1)
                        sync()
                      end
                    end
                    run asker()
                    textmsg(socket_read_string(prefix=">", suffix="<"))
                    textmsg(socket_read_binary_integer(1))
                    textmsg(socket_read_ascii_float(2))
                    textmsg(socket_read_byte_list(1))
                    textmsg(socket_read_line())
                    textmsg(socket_get_var("value"))
                  """));
    }
  }

  @Test
  void aPeerThatHangsCostsTheTimeoutOnly() throws Exception {
    try (Peer peer = Peer.that(ScriptSocketsTest::stay);
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("", "[0, -1]", "on"),
          script.run(
              open(peer)
                  + """
                    textmsg(socket_read_string(timeout=0.05))
                    textmsg(socket_read_binary_integer(1, timeout=0.05))
                    textmsg("on")
                  """));
    }
  }

  @Test
  void aPeerThatResetsEndsReadsAndSends() throws Exception {
    Peer.Conversation reset =
        client -> {
          client.setSoLinger(true, 0);
          client.close();
        };
    try (Peer peer = Peer.that(reset);
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("[0, -1, -1]", "cannot send"),
          script.run(
              open(peer)
                  + """
                    textmsg(socket_read_byte_list(2, timeout=0))
                    while socket_send_string("x"):
                      sync()
                    end
                    textmsg("cannot send")
                  """));
    }
  }

  @Test
  void aPeerThatHasEndedItsSideIsStillSpokenTo() throws Exception {
    Peer.Conversation half =
        client -> {
          say(client, "last words");
          client.shutdownOutput();
          listen(client);
        };
    try (Peer peer = Peer.that(half);
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("last words", "", "True"),
          script.run(
              open(peer)
                  + """
                    textmsg(socket_read_string())
                    textmsg(socket_read_string(timeout=0))
                    textmsg(socket_send_string("understood"))
                  """));
      assertEquals("understood", heard.take());
    }
  }

  @Test
  void whatWasSentBeforeTheEndGoesOut() throws Exception {
    Peer.Conversation talker =
        client -> {
          say(client, "greeting that nobody reads");
          listen(client);
        };
    try (Peer peer = Peer.that(talker)) {
      try (ScriptRun script = new ScriptRun()) {
        script.run(
            open(peer)
                + """
                  i = 0
                  while i < 1000:
                    socket_send_line("0123456789012345678901234567890123456789")
                    i = i + 1
                  end
                """);
      }
      assertEquals(41_000, heard.take().length());
    }
  }

  @Test
  void aPeerThatDoesNotReadIsRefusedMoreAfterAMegabyte() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    try (Peer peer = Peer.that(client -> over.await());
        ScriptRun script = new ScriptRun()) {
      List<String> said =
          script.run(
              open(peer)
                  + """
                    text = "0123456789"
                    i = 0
                    while i < 6:
                      text = str_cat(text, text)
                      i = i + 1
                    end
                    n = 0
                    while socket_send_string(text) and n < 50000:
                      n = n + 1
                    end
                    textmsg(n < 50000)
                  """);
      assertEquals(List.of("True"), said);
      over.countDown();
    }
  }

  @Test
  void aPeerThatFloodsWaitsUntilItIsRead() throws Exception {
    byte[] flood = new byte[1 << 20];
    Peer.Conversation flooding =
        client -> {
          while (true) {
            client.getOutputStream().write(flood);
          }
        };
    try (Peer peer = Peer.that(flooding);
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("1024", "1024"),
          script.run(
              open(peer)
                  + """
                    socket_read_byte_list(30)
                    sleep(0.1)
                    textmsg(str_len(socket_read_string()))
                    textmsg(str_len(socket_read_string()))
                  """));
    }
  }

  @Test
  void nobodyAtThePortIsFalse() throws Exception {
    try (ClosedPort closed = new ClosedPort();
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("False"),
          script.run("  textmsg(socket_open(\"127.0.0.1\", " + closed.number() + "))\n"));
      assertEquals(
          List.of("socket_open: \"127.0.0.1\", port " + closed.number() + ": connection refused"),
          script.reported());
    }
  }

  @Test
  void aHostWithoutANameIsFalse() throws Exception {
    try (ScriptRun script = new ScriptRun()) {
      assertEquals(List.of("False"), script.run("  textmsg(socket_open(\"\", 4000))\n"));
      assertEquals(List.of("socket_open: \"\", port 4000: no such host"), script.reported());
    }
  }

  @Test
  void whatIsNotAllowedIsNotReached() throws Exception {
    try (Peer peer = Peer.that(ScriptSocketsTest::stay);
        ScriptRun script = new ScriptRun(AllowedHosts.parse("192.168.0.0/24"))) {
      assertEquals(
          List.of("False"),
          script.run("  textmsg(socket_open(\"127.0.0.1\", " + peer.port() + "))\n"));
      assertTrue(script.reported().getFirst().endsWith("not among the allowed hosts"));
      assertEquals(0, peer.clients());
    }
  }

  /** Each of eight threads waits for its own peer; the ninth has its turn in every frame. */
  @Test
  void eightSlowPeersLeaveANinthThreadEveryFrame() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    Peer.Conversation slow =
        client -> {
          say(client, "never enough");
          over.await();
        };
    StringBuilder lines = new StringBuilder();
    try (Peer peer = Peer.that(slow);
        ScriptRun script = new ScriptRun()) {
      for (int i = 0; i < 8; i++) {
        lines.append("  thread t").append(i).append("():\n  ");
        lines.append(open(peer, "s" + i));
        lines.append("    while True:\n");
        lines.append("      socket_read_string(\"s").append(i).append("\", suffix=\"!\")\n");
        lines.append("    end\n  end\n  run t").append(i).append("()\n");
      }
      script.start(
          lines
              + """
                while True:
                  textmsg("turn")
                  sync()
                end
              """);
      long begin = script.frame();
      int turns = script.said().size();
      while (peer.clients() < 8 || script.frame() < begin + 500) {
        script.advance();
      }
      assertEquals(script.frame() - begin, script.said().size() - turns);
      over.countDown();
    }
  }
}
