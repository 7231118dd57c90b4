package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.Optional;

/** Line reader: the lines of a stream, none of them larger than it may be. */
final class LineReader {
  /** Bytes of a line at most; programs that are larger are loaded by file. */
  static final int MAX_BYTES = 1 << 20;

  private static final int BLOCK_BYTES = 1 << 16;

  private final InputStream input;
  private final byte[] block = new byte[BLOCK_BYTES];
  private int next;
  private int filled;

  LineReader(InputStream input) {
    this.input = input;
  }

  /**
   * The next line, without its end; empty when there is none any more. What follows the last line
   * end is a line as well.
   *
   * @throws RpcFailure for a line that is too long; the one behind it comes next
   */
  Optional<ByteBuffer> next() throws IOException, RpcFailure {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    boolean tooLong = false;
    while (true) {
      if (next == filled) {
        filled = Math.max(0, input.read(block));
        next = 0;
        if (filled == 0) {
          return tooLong || line.size() > 0 ? Optional.of(whole(line, tooLong)) : Optional.empty();
        }
      }
      int end = next;
      while (end < filled && block[end] != '\n') {
        end++;
      }
      tooLong |= line.size() + end - next > MAX_BYTES;
      if (!tooLong) {
        line.write(block, next, end - next);
      }
      boolean ended = end < filled;
      next = ended ? end + 1 : end;
      if (ended) {
        return Optional.of(whole(line, tooLong));
      }
    }
  }

  private static ByteBuffer whole(ByteArrayOutputStream line, boolean tooLong) throws RpcFailure {
    if (tooLong) {
      throw new RpcFailure(RpcFailure.PARSE_ERROR, text("longLine", MAX_BYTES));
    }
    return ByteBuffer.wrap(line.toByteArray());
  }
}
