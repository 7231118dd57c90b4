package org.pendant.protocols.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class MessageCutterTest {
  private final List<String> messages = new ArrayList<>();

  private MessageCutter cutter(Dissector dissector) {
    return new MessageCutter(
        Direction.IN,
        dissector,
        (reading, bytes) -> messages.add(reading.type() + " " + Dissector.text(bytes).strip()));
  }

  private static ByteBuffer bytes(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  @Test
  void putsMessagesTogetherFromPiecesCutAnywhere() {
    MessageCutter cutter = cutter(new LineDissector(line -> Optional.empty()));
    for (String piece : List.of("pl", "", "ay\nst", "o", "p\n\nquit\nlo")) {
      cutter.take(bytes(piece));
    }
    assertEquals(List.of("line play", "line stop", "line ", "line quit"), messages);
  }

  @Test
  void handsOnWhatHadBegunWhenBytesAreMissing() {
    MessageCutter cutter = cutter(new LineDissector(line -> Optional.empty()));
    cutter.take(bytes("pl"));
    cutter.missed();
    cutter.take(bytes("stop\n"));
    assertEquals(List.of("text pl", "line stop"), messages);
  }

  @Test
  void handsOnAsItIsWhatIsNotOfTheProtocol() {
    Dissector strict =
        new Dissector() {
          @Override
          public int length(Direction direction, ByteBuffer bytes) {
            return bytes.get(bytes.position()) == 'x' ? UNKNOWN : 1;
          }

          @Override
          public Reading read(Direction direction, ByteBuffer message) {
            if (message.get() == 'b') {
              throw new IllegalArgumentException("b");
            }
            return Reading.of("letter", "");
          }
        };
    MessageCutter cutter = cutter(strict);
    cutter.take(bytes("abxyz"));
    cutter.take(bytes("a"));
    assertEquals(List.of("letter a", "text b", "text xyz", "letter a"), messages);
  }

  @Test
  void keepsNoMoreThanTheLongestMessage() {
    MessageCutter cutter = cutter(new LineDissector(line -> Optional.empty()));
    cutter.take(bytes("a".repeat(MessageCutter.MAX_BYTES)));
    assertEquals(0, messages.size());
    cutter.take(bytes("a"));
    assertEquals(1, messages.size());
  }
}
