package org.pendant.protocols.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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

  private static final HttpCutter.Limits LIMITS =
      (method, path) ->
          path.equals("/large")
              ? new BodyLimit(100_000, 200_000, Optional.of(new LargeBodies(1)))
              : BodyLimit.USUAL;

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
          expected,
          cut(new HttpCutter(LIMITS), TWO.substring(0, i), TWO.substring(i)),
          "cut at " + i);
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
    assertThrows(ProtocolException.class, () -> cut(new HttpCutter(LIMITS), text));
  }

  private static List<HttpCall> calls(HttpCutter cutter, byte[] sent, int piece)
      throws ProtocolException {
    List<HttpCall> calls = new ArrayList<>();
    for (int from = 0; from < sent.length; from += piece) {
      ByteBuffer bytes = ByteBuffer.wrap(sent, from, Math.min(piece, sent.length - from));
      while (bytes.hasRemaining()) {
        cutter.next(bytes).ifPresent(calls::add);
      }
    }
    return calls;
  }

  private static byte[] large(int count) {
    String head = "PUT /large HTTP/1.1\r\nX-Case: AbC\r\nContent-Length: " + count + "\r\n\r\n";
    return (head + "0123456789".repeat(count / 10 + 1).substring(0, count))
        .getBytes(StandardCharsets.ISO_8859_1);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 7, 65_536, 1_000_000})
  void keepsALargeBodyWhereItIsAllowed(int piece) throws ProtocolException {
    HttpCall call = calls(new HttpCutter(LIMITS), large(100_000), piece).getFirst();
    assertEquals(Optional.empty(), call.notKept());
    assertEquals(
        "0123456789".repeat(10_000), StandardCharsets.ISO_8859_1.decode(call.body()).toString());
    assertEquals("AbC", call.headers().get("x-case"));
  }

  @Test
  void passesOverABodyThatIsTooLargeAndGoesOnBehindIt() throws ProtocolException {
    HttpCutter cutter = new HttpCutter(LIMITS);
    HttpCall call = calls(cutter, large(100_001), 5_000).getFirst();
    assertEquals(Optional.of(HttpStatus.TOO_LARGE), call.notKept());
    assertEquals(0, call.body().remaining());
    assertEquals(
        List.of("POST /RPC2 true hello", "GET /a/b false ", "POST / false "), cut(cutter, TWO));
    assertThrows(ProtocolException.class, () -> calls(cutter, large(200_001), 5_000));
  }

  @Test
  void largeBodiesTakePlacesUntilTheyAreForgotten() throws ProtocolException {
    BodyLimit limit = new BodyLimit(100_000, 200_000, Optional.of(new LargeBodies(1)));
    HttpCutter first = new HttpCutter((method, path) -> limit);
    HttpCutter second = new HttpCutter((method, path) -> limit);
    assertEquals(Optional.empty(), calls(first, large(70_000), 900).getFirst().notKept());
    assertEquals(
        Optional.of(HttpStatus.UNAVAILABLE),
        calls(second, large(70_000), 900).getFirst().notKept());
    assertEquals(Optional.empty(), calls(second, large(60_000), 900).getFirst().notKept());
    first.forget();
    first.forget();
    second.forget();
    assertEquals(Optional.empty(), calls(second, large(70_000), 900).getFirst().notKept());
    assertEquals(
        Optional.of(HttpStatus.UNAVAILABLE), calls(first, large(70_000), 900).getFirst().notKept());
  }

  @Test
  void whoHoldsTheBodyBackIsToldOnceToGoOn() throws ProtocolException {
    HttpCutter cutter = new HttpCutter(LIMITS);
    cut(cutter, "POST / HTTP/1.1\r\nExpect: 100-Continue\r\nContent-Length: 5\r\n");
    assertFalse(cutter.tellToGoOn());
    cut(cutter, "\r\n");
    assertTrue(cutter.tellToGoOn());
    assertFalse(cutter.tellToGoOn());
    assertEquals(List.of("POST / true hello"), cut(cutter, "hello"));
    for (String other :
        List.of(
            "POST / HTTP/1.1\r\nContent-Length: 5\r\n\r\n",
            "POST / HTTP/1.0\r\nExpect: 100-continue\r\nContent-Length: 5\r\n\r\n",
            "POST / HTTP/1.1\r\nExpect: 100-continue\r\nContent-Length: 0\r\n\r\n",
            "POST /large HTTP/1.1\r\nExpect: 100-continue\r\nContent-Length: 100001\r\n\r\n")) {
      HttpCutter fresh = new HttpCutter(LIMITS);
      cut(fresh, other);
      assertFalse(fresh.tellToGoOn(), other);
    }
  }

  @Test
  void refusesAHeadWithoutEnd() {
    String endless = "x".repeat(HttpCutter.MAX_HEAD + 1);
    assertThrows(ProtocolException.class, () -> cut(new HttpCutter(LIMITS), endless));
  }
}
