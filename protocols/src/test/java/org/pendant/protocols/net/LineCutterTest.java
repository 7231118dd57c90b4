package org.pendant.protocols.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class LineCutterTest {
  private static final int LONGEST = 20;

  private static ByteBuffer bytes(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  @Test
  void aLineEndsWithALineFeed() throws ProtocolException {
    LineCutter lines = new LineCutter(LONGEST);
    assertEquals(List.of("one", "", "two"), lines.take(bytes("one\n\ntwo\nthr")));
    assertEquals(List.of("three"), lines.take(bytes("ee\n")));
  }

  @Test
  void aCarriageReturnBeforeItDoesNotCount() throws ProtocolException {
    assertEquals(List.of("a\rb"), new LineCutter(LONGEST).take(bytes("a\rb\r\n")));
  }

  @Test
  void bytesStayWhatTheyAre() throws ProtocolException {
    assertEquals(
        List.of("\u00e4\u00ff\0"), new LineCutter(LONGEST).take(bytes("\u00e4\u00ff\0\n")));
  }

  @Test
  void everyCutGivesTheSameLines() throws ProtocolException {
    String text = "power on\nload a.urp\r\n\nquit\n";
    List<String> whole = new LineCutter(LONGEST).take(bytes(text));
    for (int cut = 0; cut <= text.length(); cut++) {
      LineCutter lines = new LineCutter(LONGEST);
      List<String> parts = new ArrayList<>(lines.take(bytes(text.substring(0, cut))));
      parts.addAll(lines.take(bytes(text.substring(cut))));
      assertEquals(whole, parts, "cut at " + cut);
    }
  }

  @Test
  void aLineMayBeAsLongAsIsAllowed() throws ProtocolException {
    String longest = "x".repeat(LONGEST);
    assertEquals(List.of(longest), new LineCutter(LONGEST).take(bytes(longest + "\n")));
  }

  @Test
  void refusesALineThatIsLonger() {
    LineCutter lines = new LineCutter(LONGEST);
    String message =
        assertThrows(ProtocolException.class, () -> lines.take(bytes("x".repeat(LONGEST + 1))))
            .getMessage();
    assertEquals("a line has more than 20 bytes", message);
  }

  @Test
  void randomBytesAreCutOrRefused() {
    SplittableRandom random = new SplittableRandom(6);
    for (int i = 0; i < 2000; i++) {
      byte[] noise = new byte[random.nextInt(60)];
      random.nextBytes(noise);
      LineCutter lines = new LineCutter(LONGEST);
      try {
        for (String each : lines.take(ByteBuffer.wrap(noise))) {
          assertEquals(-1, each.indexOf('\n'), "round " + i);
        }
      } catch (ProtocolException e) {
        assertEquals("a line has more than 20 bytes", e.getMessage(), "round " + i);
      }
    }
  }
}
