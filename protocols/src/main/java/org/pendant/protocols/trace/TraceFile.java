package org.pendant.protocols.trace;

import static org.pendant.protocols.trace.TraceTexts.text;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;

/** Trace file: where a trace is kept, in a form by the ending of its name. */
public final class TraceFile {
  /** A trace ends when its file has become so long. */
  public static final long MAX_BYTES = 4L << 30;

  private static final int BUFFER_BYTES = 1 << 16;

  private TraceFile() {}

  /**
   * Begins a trace.
   *
   * @param name {@code .pcap} for packets that Wireshark opens; others get a JSON object a line
   * @param file is closed at the end
   * @param robotTimeS robot time, s; any thread, must not wait
   * @param trouble is told why the file cannot be written any more
   */
  public static WireTrace begin(
      Path name, OutputStream file, DoubleSupplier robotTimeS, Consumer<String> trouble)
      throws IOException {
    return new WireTrace(
            robotTimeS,
            InstantSource.system(),
            sink(name, new BufferedOutputStream(new Bounded(file, MAX_BYTES), BUFFER_BYTES)),
            trouble)
        .start();
  }

  private static TraceSink sink(Path name, OutputStream file) throws IOException {
    return packets(name) ? new PcapSink(new PcapWriter(file)) : new JsonSink(new JsonWriter(file));
  }

  /** Whether a file of this name has packets. */
  public static boolean packets(Path name) {
    return name.toString().toLowerCase(Locale.ROOT).endsWith(".pcap");
  }

  /** A stream that takes so many bytes and no more. */
  private static final class Bounded extends OutputStream {
    private final OutputStream out;
    private long left;

    Bounded(OutputStream out, long most) {
      this.out = out;
      left = most;
    }

    @Override
    public void write(int one) throws IOException {
      write(new byte[] {(byte) one}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
      if (count > left) {
        left = 0;
        throw new IOException(text("fileFull", MAX_BYTES >> 30));
      }
      left -= count;
      out.write(bytes, from, count);
    }

    @Override
    public void flush() throws IOException {
      out.flush();
    }

    @Override
    public void close() throws IOException {
      out.close();
    }
  }
}
