package org.pendant.protocols.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.protocols.net.ProtocolException;

class HttpCutterTest {
  private static final String TWO =
      "POST /RPC2 HTTP/1.1\r\nHost: x\r\nContent-Length: 5\r\n\r\nhello"
          + "GET /a/b?c=d HTTP/1.0\n\n"
          + "POST / HTTP/1.1\r\nConnection: close\r\ncontent-length: 0\r\n\r\n";

  private static List<String> cut(HttpCutter cutter, String... pieces) throws ProtocolException {
    List<String> calls = new ArrayList<>();
    for (String piece : pieces) {
      ByteBuffer bytes = ByteBuffer.wrap(piece.getBytes(StandardCharsets.ISO_8859_1));
      for (Optional<HttpCall> next = cutter.next(bytes);
          next.isPresent();
          next = cutter.next(bytes)) {
        String body = StandardCharsets.ISO_8859_1.decode(next.get().body()).toString();
        calls.add(
            next.get().method() + " " + next.get().path() + " " + next.get().keep() + " " + body);
      }
    }
    return calls;
  }

  @Test
  void takesRequestsThatAreCutAnywhere() throws ProtocolException {
    List<String> expected = List.of("POST /RPC2 true hello", "GET /a/b false ", "POST / false ");
    for (int i = 0; i <= TWO.length(); i++) {
      assertEquals(
          expected, cut(new HttpCutter(), TWO.substring(0, i), TWO.substring(i)), "cut at " + i);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\n\n",
        "hello\n\n",
        "POST / HTTP/2\n\n",
        "POST / HTTP/1.1\nno header\n\n",
        "POST / HTTP/1.1\nContent-Length: -1\n\n",
        "POST / HTTP/1.1\nContent-Length: 65537\n\n",
        "POST / HTTP/1.1\nContent-Length: 99999999999\n\n",
        "POST / HTTP/1.1\nTransfer-Encoding: chunked\n\n"
      })
  void refusesWhatIsNoRequest(String text) {
    assertThrows(ProtocolException.class, () -> cut(new HttpCutter(), text));
  }

  @Test
  void refusesAHeadWithoutEnd() {
    String endless = "x".repeat(HttpCutter.LONGEST_HEAD + 1);
    assertThrows(ProtocolException.class, () -> cut(new HttpCutter(), endless));
  }
}
