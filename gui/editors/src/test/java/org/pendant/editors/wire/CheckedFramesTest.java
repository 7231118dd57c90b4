package org.pendant.editors.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What of a client's bytes is let through. */
final class CheckedFramesTest {
  private final List<String> complaints = new ArrayList<>();

  private String through(String bytes) throws IOException {
    try (CheckedFrames frames =
        new CheckedFrames(
            new ByteArrayInputStream(bytes.getBytes(StandardCharsets.ISO_8859_1)),
            complaints::add)) {
      return new String(frames.readAllBytes(), StandardCharsets.ISO_8859_1);
    }
  }

  private static String frame(String body) {
    return "Content-Length: " + body.length() + "\r\n\r\n" + body;
  }

  @Test
  void framesPassAsTheyAreWithTheHeadThatCounts() throws IOException {
    String typed =
        "Content-Type: application/vscode-jsonrpc; charset=utf-8\r\ncontent-length:2\r\n\r\n{}";
    assertEquals(frame("{}") + frame("[1]"), through(typed + frame("[1]")));
    assertEquals(List.of(), complaints);
  }

  @Test
  void aHeadWithoutALengthIsLeftOutAndTold() throws IOException {
    assertEquals(frame("{}"), through("Length: 2\r\n\r\n" + frame("{}")));
    assertEquals(List.of("a message is left out, its head has no Content-Length"), complaints);
  }

  @Test
  void aLengthThatIsNoNumberIsLeftOut() throws IOException {
    assertEquals(frame("{}"), through("Content-Length: -5\r\n\r\n" + frame("{}")));
    assertEquals(frame("{}"), through("Content-Length: 99999999999999999\r\n\r\n" + frame("{}")));
    assertEquals(2, complaints.size());
  }

  @Test
  void aMessageThatIsTooLongIsSkippedAndTold() throws IOException {
    int length = CheckedFrames.MAX_MESSAGE + 1;
    assertEquals(
        frame("{}"),
        through("Content-Length: " + length + "\r\n\r\n" + "x".repeat(length) + frame("{}")));
    assertEquals(
        List.of("a message of 67108865 bytes is left out, the most is 67108864"), complaints);
  }

  @Test
  void aHeadWithoutEndTakesNoMoreThanItsLimit() throws IOException {
    assertEquals("", through("X: " + "y".repeat(1 << 20)));
    assertEquals(frame("{}"), through("X: " + "y".repeat(1 << 20) + "\r\n" + frame("{}")));
    assertEquals(List.of("a message with a head of more than 4096 bytes is left out"), complaints);
  }

  @Test
  void anyBytesEndTheStreamAndNothingElse() throws IOException {
    Random random = new Random(3);
    for (int round = 0; round < 500; round++) {
      StringBuilder bytes = new StringBuilder();
      for (int i = 0; i < 6; i++) {
        switch (random.nextInt(4)) {
          case 0 -> bytes.append(frame("{\"a\":1}"));
          case 1 -> bytes.append("Content-Length: ").append(random.nextInt(20) - 5).append("\r\n");
          case 2 -> bytes.append((char) random.nextInt(256)).append("\n\r\n");
          default -> bytes.append(frame("{}"), 0, random.nextInt(frame("{}").length()));
        }
      }
      through(bytes.toString());
    }
  }
}
