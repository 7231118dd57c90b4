package org.pendant.command.rpc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class LineReaderTest {
  private static LineReader of(String text) {
    return new LineReader(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  private static Optional<String> next(LineReader reader) throws IOException, RpcFailure {
    return reader.next().map(LineReaderTest::text);
  }

  private static String text(ByteBuffer line) {
    return StandardCharsets.UTF_8.decode(line).toString();
  }

  @Test
  void linesComeOneByOneAndTheLastNeedsNoEnd() throws Exception {
    LineReader reader = of("one\n\ntwo\nthree");
    assertEquals(Optional.of("one"), next(reader));
    assertEquals(Optional.of(""), next(reader));
    assertEquals(Optional.of("two"), next(reader));
    assertEquals(Optional.of("three"), next(reader));
    assertEquals(Optional.empty(), next(reader));
  }

  @Test
  void lineMayComeInAnyPieces() throws Exception {
    byte[] bytes = "{\"ä\": 1}\nnext\n".getBytes(StandardCharsets.UTF_8);
    LineReader reader =
        new LineReader(
            new InputStream() {
              private int at;

              @Override
              public int read() {
                return at == bytes.length ? -1 : bytes[at++] & 0xFF;
              }

              @Override
              public int read(byte[] into, int from, int most) {
                int each = read();
                if (each < 0) {
                  return -1;
                }
                into[from] = (byte) each;
                return 1;
              }
            });
    assertEquals(Optional.of("{\"ä\": 1}"), next(reader));
    assertEquals(Optional.of("next"), next(reader));
  }

  @Test
  void lineThatIsTooLongIsRefusedAndTheNextOneRead() throws Exception {
    LineReader reader = of("x".repeat(3 * LineReader.MAX_BYTES) + "\nshort\n");
    RpcFailure refusal = assertThrows(RpcFailure.class, reader::next);
    assertEquals("the line has more than 1048576 bytes", refusal.getMessage());
    assertEquals(RpcFailure.PARSE_ERROR, refusal.code());
    assertEquals(Optional.of("short"), next(reader));
  }

  @Test
  void longestLineIsRead() throws Exception {
    LineReader reader = of("x".repeat(LineReader.MAX_BYTES) + "\n");
    assertEquals(LineReader.MAX_BYTES, next(reader).orElseThrow().length());
  }
}
