package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;

/**
 * Recording writer: writes a {@code .rec} file frame by frame, at any length with the same memory.
 * Equal frames make equal files. What it flushes is whole blocks: the header with the first
 * snapshot at once, and from then on at least one block for each minute in which something changes.
 * One thread uses it.
 */
public final class RecordingWriter implements Closeable {
  /** An arm at rest fills no block for a long time, and it is lost when the process is killed. */
  private static final int MAX_FRAMES_A_BLOCK = 60 * FrameTime.FRAMES_PER_SECOND;

  private final OutputStream out;
  private final Deflater deflater = new Deflater(Deflater.BEST_SPEED);
  private final SnapshotEncoder snapshotEncoder;
  private final List<Segment> full = new ArrayList<>();
  private Optional<RecordedProgram> lastText = Optional.empty();
  private long lastFrame;
  private boolean closed;

  /**
   * Begins a file with a snapshot, such as the one before the first frame.
   *
   * @param out gets the file, and is closed with the writer
   */
  public RecordingWriter(OutputStream out, ControllerState start) throws IOException {
    this(out, start, SnapshotEncoder.AMBIENT_FRAMES, false);
  }

  /**
   * As the public constructor.
   *
   * @param ambientFrames that of {@link SnapshotEncoder}
   * @param received whether it is of a controller that is listened to
   */
  RecordingWriter(OutputStream out, ControllerState start, int ambientFrames, boolean received)
      throws IOException {
    this.out = out;
    lastFrame = start.frame();
    snapshotEncoder = new SnapshotEncoder(start, next -> {}, full::add, ambientFrames);
    ByteSink header = new ByteSink();
    FileFormat.writeHeader(new FileFormat.Header(start.arm().description(), received), header);
    out.write(FileFormat.MAGIC);
    out.write(
        littleEndian(3 * Integer.BYTES)
            .putInt(FileFormat.VERSION)
            .putInt(header.size())
            .putInt(checksum(header.array(), header.size()))
            .array());
    out.write(header.array(), 0, header.size());
    writeWhatIsThere();
  }

  /** Takes the next frame. */
  public void write(ControllerState state) throws IOException {
    snapshotEncoder.take(state);
    lastFrame = state.frame();
    for (Segment each : full) {
      writeSegment(each);
    }
    full.clear();
    if (state.frame() - snapshotEncoder.segment().firstFrame() >= MAX_FRAMES_A_BLOCK) {
      writeWhatIsThere();
    }
  }

  private void writeWhatIsThere() throws IOException {
    Optional<Segment> segment = snapshotEncoder.cut();
    if (segment.isPresent()) {
      writeSegment(segment.get());
    }
  }

  /** Nothing more changes until frame {@code frame}, which is the last. */
  void end(long frame) {
    lastFrame = Math.max(lastFrame, frame);
  }

  /** Takes the text of a program that has started. */
  public void note(RecordedProgram text) throws IOException {
    ByteSink sink = new ByteSink();
    sink.whole(text.frame());
    sink.text(text.name());
    sink.text(text.source().name());
    boolean known = lastText.isPresent() && lastText.get().sameText(text);
    sink.bool(known);
    if (!known) {
      byte[] bytes = text.source().text().getBytes(StandardCharsets.ISO_8859_1);
      sink.count(bytes.length);
      sink.raw(bytes);
    }
    writeBlock(FileFormat.PROGRAM, sink);
    lastText = Optional.of(text);
  }

  private void writeSegment(Segment segment) throws IOException {
    ByteSink sink = new ByteSink();
    SegmentBytes.write(segment, segment.published(), sink);
    writeBlock(FileFormat.FRAMES, sink);
  }

  private void writeBlock(int kind, ByteSink sink) throws IOException {
    if (sink.size() > FileFormat.MAX_BLOCK_BYTES) {
      throw new IOException(
          text("tooMuchAtOnce", lastFrame, sink.size(), FileFormat.MAX_BLOCK_BYTES));
    }
    byte[] deflated = new byte[sink.size() + 64 + sink.size() / 1000];
    deflater.reset();
    deflater.setInput(sink.array(), 0, sink.size());
    deflater.finish();
    int length = deflater.deflate(deflated);
    if (!deflater.finished()) {
      throw new IllegalStateException("a block of " + sink.size() + " bytes became longer");
    }
    out.write(
        littleEndian(FileFormat.BLOCK_HEADER)
            .put((byte) kind)
            .putInt(sink.size())
            .putInt(length)
            .putInt(checksum(deflated, length))
            .array());
    out.write(deflated, 0, length);
    out.flush();
  }

  static ByteBuffer littleEndian(int size) {
    return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
  }

  static int checksum(byte[] bytes, int length) {
    CRC32 crc = new CRC32();
    crc.update(bytes, 0, length);
    return (int) crc.getValue();
  }

  /** Writes what is left and the end. */
  @Override
  public void close() throws IOException {
    if (closed) {
      return;
    }
    closed = true;
    try (out) {
      writeWhatIsThere();
      ByteSink end = new ByteSink();
      end.whole(lastFrame);
      writeBlock(FileFormat.END, end);
    } finally {
      deflater.end();
    }
  }
}
