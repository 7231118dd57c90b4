package org.pendant.editors.lsp.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import org.eclipse.lsp4j.Position;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.ByteText;

/** Places in a text, counted in bytes and as the protocol counts. */
final class TextPositionsTest {

  private static TextPositions utf16(String text) {
    return new TextPositions(ByteText.asBytes(text), PositionEncoding.UTF16);
  }

  private static TextPositions utf8(String text) {
    return new TextPositions(ByteText.asBytes(text), PositionEncoding.UTF8);
  }

  @Test
  void charactersOutsideAsciiCountAsTheClientCountsThem() {
    String text = "# µ 🤖 x\n";
    assertEquals(new Position(0, 7), utf16(text).position(10));
    assertEquals(new Position(0, 10), utf8(text).position(10));
    assertEquals(10, utf16(text).offset(new Position(0, 7)));
    assertEquals(10, utf8(text).offset(new Position(0, 10)));
  }

  @Test
  void aPlaceInsideACharacterIsItsStart() {
    assertEquals(0, utf16("🤖").offset(new Position(0, 1)));
    assertEquals(0, utf8("🤖").offset(new Position(0, 2)));
  }

  @Test
  void whatLiesBeyondALineOrTheTextIsItsEnd() {
    TextPositions positions = utf16("ab\r\ncd");
    assertEquals(2, positions.offset(new Position(0, 99)));
    assertEquals(6, positions.offset(new Position(1, Integer.MAX_VALUE)));
    assertEquals(6, positions.offset(new Position(5, 0)));
    assertEquals(0, positions.offset(new Position(-1, 3)));
    assertEquals(4, positions.offset(new Position(1, -3)));
  }

  @Test
  void linesEndWithLineFeedCarriageReturnOrBoth() {
    TextPositions positions = utf16("a\nb\rc\r\nd");
    assertEquals(4, positions.lineCount());
    assertEquals(new Position(1, 0), positions.position(2));
    assertEquals(new Position(2, 0), positions.position(4));
    assertEquals(new Position(3, 0), positions.position(7));
  }

  @Test
  void positionsOfAnyTextLeadBackToTheirOffsets() {
    Random random = new Random(7);
    List<String> pieces = List.of("a", "é", "€", "🤖", "\n", "\r\n", "\r", "  ", "p[");
    for (int round = 0; round < 300; round++) {
      StringBuilder text = new StringBuilder();
      for (int i = random.nextInt(40); i > 0; i--) {
        text.append(pieces.get(random.nextInt(pieces.size())));
      }
      for (TextPositions positions : List.of(utf16(text.toString()), utf8(text.toString()))) {
        int offset = 0;
        for (int point : text.codePoints().toArray()) {
          int end = offset + Character.toString(point).getBytes(StandardCharsets.UTF_8).length;
          // The end of a line is before what ends it.
          if (point != '\n' && point != '\r') {
            assertEquals(offset, positions.offset(positions.position(offset)), text.toString());
          }
          offset = end;
        }
      }
    }
  }
}
