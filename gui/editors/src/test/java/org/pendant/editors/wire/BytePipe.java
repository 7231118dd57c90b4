package org.pendant.editors.wire;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * Byte pipe: what is written to one stream is read from the other. Unlike piped streams of the JDK
 * it does not mind when the thread that wrote last has ended.
 */
public final class BytePipe {
  private static final byte[] END = {};

  private final BlockingQueue<byte[]> pieces = new LinkedBlockingQueue<>();
  private final Output output = new Output();
  private final Input input = new Input();

  public OutputStream output() {
    return output;
  }

  public InputStream input() {
    return input;
  }

  private final class Output extends OutputStream {
    private boolean closed;

    @Override
    public void write(int each) throws IOException {
      write(new byte[] {(byte) each}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int offset, int length) throws IOException {
      if (closed) {
        throw new IOException("the pipe is closed");
      }
      if (length > 0) {
        pieces.add(Arrays.copyOfRange(bytes, offset, offset + length));
      }
    }

    @Override
    public synchronized void close() {
      if (!closed) {
        closed = true;
        pieces.add(END);
      }
    }
  }

  private final class Input extends InputStream {
    private byte[] piece = END;
    private int at;
    private boolean ended;

    @Override
    public int read() throws IOException {
      byte[] one = new byte[1];
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public synchronized int read(byte[] target, int offset, int length) throws IOException {
      if (length == 0) {
        return 0;
      }
      while (at == piece.length && !ended) {
        try {
          piece = pieces.take();
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          throw new IOException("interrupted", e);
        }
        at = 0;
        ended = piece.length == 0;
      }
      if (ended) {
        return -1;
      }
      int count = Math.min(length, piece.length - at);
      System.arraycopy(piece, at, target, offset, count);
      at += count;
      return count;
    }
  }
}
