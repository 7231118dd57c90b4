package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.AccessMode;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.pendant.language.source.Source;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.time.FrameTime;

/**
 * Recording file: opens {@code .rec} files. All of a file is read and checked once, which takes a
 * while: not for the dispatch thread. Later it is read again in pieces on demand, so that memory
 * does not grow with its length.
 */
public final class RecordingFile {
  /** With so many bytes each file begins in the same way. */
  public static final int MARK_BYTES = FileFormat.MAGIC.length;

  /** Blocks that are kept in memory. */
  private static final int KEPT = 24;

  /** More blocks are no file of ours: a year at rest has fewer. */
  private static final int MAX_BLOCKS = 1 << 20;

  /** Frames of a year in which nothing changes. */
  private static final long MAX_FRAMES_AT_REST = 366L * 24 * 3600 * FrameTime.FRAMES_PER_SECOND;

  private final Path file;
  private final Map<Integer, Segment> kept =
      new LinkedHashMap<>(2 * KEPT, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Integer, Segment> eldest) {
          return size() > KEPT;
        }
      };

  private RecordingFile(Path file) {
    this.file = file;
  }

  /**
   * A file that was opened.
   *
   * @param recording what is in it
   * @param warning that it is cut off, in words for people; empty when it is whole
   */
  public record Opened(Recording recording, Optional<String> warning) {}

  /** What is in a block, before it has been looked at. */
  private record Block(int kind, int inflated, int deflated, int checksum, long place) {}

  private final class InFile implements SegmentRef {
    private final int number;
    private final Block block;
    private final long firstFrame;

    private InFile(int number, Block block, long firstFrame) {
      this.number = number;
      this.block = block;
      this.firstFrame = firstFrame;
    }

    @Override
    public long firstFrame() {
      return firstFrame;
    }

    @Override
    public boolean inMemory() {
      synchronized (kept) {
        return kept.containsKey(number);
      }
    }

    @Override
    public Segment segment() {
      synchronized (kept) {
        Segment known = kept.get(number);
        if (known != null) {
          return known;
        }
      }
      Segment read = readAgain(block);
      synchronized (kept) {
        kept.put(number, read);
      }
      return read;
    }
  }

  /**
   * Opens a file.
   *
   * @throws RecordingException if it is none of ours, of another version, damaged or without a
   *     single whole block; the message says what
   * @throws IOException if it cannot be read
   */
  public static Opened open(Path file) throws IOException {
    return new RecordingFile(file).read();
  }

  /** Whether a file that begins with these bytes is a recording, of this version or another. */
  public static boolean begins(byte[] bytes) {
    return bytes.length >= MARK_BYTES
        && Arrays.equals(bytes, 0, MARK_BYTES, FileFormat.MAGIC, 0, MARK_BYTES);
  }

  private Opened read() throws IOException {
    try (RandomAccessFile in = reading()) {
      FileFormat.Header header = header(in);
      List<InFile> stretches = new ArrayList<>();
      ProgramTexts texts = ProgramTexts.NONE;
      long last = 0;
      int lastCount = 0;
      int blocks = 0;
      Optional<Block> next = nextBlock(in);
      while (next.isPresent() && next.get().kind() != FileFormat.END) {
        Block block = next.get();
        blocks++;
        if (blocks > MAX_BLOCKS) {
          throw refused(text("tooManyBlocks", MAX_BLOCKS));
        }
        if (block.kind() == FileFormat.PROGRAM) {
          texts = texts.with(program(block, in, texts));
        } else {
          Segment segment = segment(block, in);
          if (!stretches.isEmpty() && segment.firstFrame() < last) {
            throw at(block, text("framesOutOfOrder", segment.firstFrame(), last));
          }
          stretches.add(new InFile(stretches.size(), block, segment.firstFrame()));
          lastCount = segment.published();
          last = segment.frame(lastCount - 1);
        }
        next = nextBlock(in);
      }
      if (stretches.isEmpty()) {
        throw refused(text("noWholeBlock"));
      }
      Optional<String> warning = Optional.empty();
      if (next.isPresent()) {
        last = lastFrame(next.get(), in, last);
      } else {
        warning = Optional.of(text("cutOff", file.getFileName(), Recording.timeS(last)));
      }
      Snapshots snapshots = new Snapshots(header.arm(), new ForwardKinematics(header.arm()));
      return new Opened(
          new Recording(stretches, lastCount, last, texts, snapshots, header.received()), warning);
    }
  }

  /** The file; unlike the constructor this tells apart why it cannot be read. */
  private RandomAccessFile reading() throws IOException {
    file.getFileSystem().provider().checkAccess(file, AccessMode.READ);
    if (Files.isDirectory(file)) {
      throw new FileSystemException(file.toString(), null, text("isFolder"));
    }
    return new RandomAccessFile(file.toFile(), "r");
  }

  private RecordingException refused(String why) {
    return new RecordingException(file.getFileName() + ": " + why);
  }

  private RecordingException at(Block block, String why) {
    return refused(text("blockRefused", block.place(), why));
  }

  private FileFormat.Header header(RandomAccessFile in) throws IOException {
    byte[] bytes = new byte[FileFormat.MAGIC.length + 3 * Integer.BYTES];
    boolean whole = fill(in, bytes);
    if (!Arrays.equals(
        bytes, 0, FileFormat.MAGIC.length, FileFormat.MAGIC, 0, FileFormat.MAGIC.length)) {
      throw refused(text("noRecording"));
    }
    if (!whole) {
      throw refused(text("endsInHeader"));
    }
    ByteBuffer start = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    start.position(FileFormat.MAGIC.length);
    int version = start.getInt();
    if (version != FileFormat.VERSION) {
      throw refused(text("otherVersion", version, FileFormat.VERSION));
    }
    int length = start.getInt();
    int checksum = start.getInt();
    if (length < 0 || length > FileFormat.MAX_HEADER_BYTES) {
      throw refused(text("headerTooLong", length, FileFormat.MAX_HEADER_BYTES));
    }
    byte[] header = new byte[length];
    if (!fill(in, header)) {
      throw refused(text("endsInHeader"));
    }
    if (RecordingWriter.checksum(header, length) != checksum) {
      throw refused(text("headerChecksum"));
    }
    try {
      return FileFormat.readHeader(new ByteSource(header));
    } catch (MalformedBytes e) {
      throw refused(e.getMessage());
    }
  }

  /** The header of the next block that is whole; empty where the file ends before its end. */
  private Optional<Block> nextBlock(RandomAccessFile in) throws IOException {
    long place = in.getFilePointer();
    byte[] bytes = new byte[FileFormat.BLOCK_HEADER];
    if (!fill(in, bytes)) {
      return Optional.empty();
    }
    ByteBuffer header = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    Block block = new Block(header.get(), header.getInt(), header.getInt(), header.getInt(), place);
    if (block.kind() < FileFormat.FRAMES || block.kind() > FileFormat.END) {
      throw at(block, text("blockKind", block.kind(), FileFormat.END));
    }
    if (block.inflated() < 0
        || block.inflated() > FileFormat.MAX_BLOCK_BYTES
        || block.deflated() < 0
        || block.deflated() > FileFormat.MAX_BLOCK_BYTES + FileFormat.MAX_BLOCK_BYTES / 100
        || block.inflated() / FileFormat.MAX_RATIO > block.deflated()) {
      throw at(block, text("blockLengths", block.deflated(), block.inflated()));
    }
    return in.length() - in.getFilePointer() < block.deflated()
        ? Optional.empty()
        : Optional.of(block);
  }

  private byte[] inflated(Block block, RandomAccessFile in) throws IOException {
    byte[] deflated = new byte[block.deflated()];
    in.seek(block.place() + FileFormat.BLOCK_HEADER);
    if (!fill(in, deflated)) {
      throw at(block, text("blockShorter"));
    }
    if (RecordingWriter.checksum(deflated, block.deflated()) != block.checksum()) {
      throw at(block, text("blockChecksum"));
    }
    byte[] bytes = new byte[block.inflated()];
    try (Inflater inflater = new Inflater()) {
      inflater.setInput(deflated);
      int length = inflater.inflate(bytes);
      if (length != bytes.length || (!inflater.finished() && inflater.inflate(new byte[1]) > 0)) {
        throw at(block, text("blockLength"));
      }
    } catch (DataFormatException e) {
      throw at(block, text("blockNotInflated", e.getMessage()));
    }
    return bytes;
  }

  /** Whether there was as much as wanted. */
  private static boolean fill(RandomAccessFile in, byte[] bytes) throws IOException {
    int filled = 0;
    while (filled < bytes.length) {
      int count = in.read(bytes, filled, bytes.length - filled);
      if (count < 0) {
        return false;
      }
      filled += count;
    }
    return true;
  }

  private Segment segment(Block block, RandomAccessFile in) throws IOException {
    try {
      return SegmentBytes.read(new ByteSource(inflated(block, in)));
    } catch (MalformedBytes | IllegalArgumentException e) {
      throw at(block, e.getMessage());
    }
  }

  private Segment readAgain(Block block) {
    try (RandomAccessFile in = reading()) {
      return segment(block, in);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private RecordedProgram program(Block block, RandomAccessFile in, ProgramTexts texts)
      throws IOException {
    ByteSource bytes = new ByteSource(inflated(block, in));
    try {
      long frame = bytes.whole();
      String name = bytes.text();
      String sourceName = bytes.text();
      if (bytes.bool()) {
        if (texts.all().isEmpty()) {
          throw new MalformedBytes(text("repeatsNoProgram"));
        }
        return new RecordedProgram(frame, name, texts.all().getLast().source());
      }
      return new RecordedProgram(frame, name, Source.of(sourceName, bytes.raw(bytes.count(1))));
    } catch (MalformedBytes e) {
      throw at(block, e.getMessage());
    }
  }

  private long lastFrame(Block end, RandomAccessFile in, long last) throws IOException {
    try {
      long frame = new ByteSource(inflated(end, in)).whole();
      if (frame < last || frame - last > MAX_FRAMES_AT_REST) {
        throw new MalformedBytes(text("lastFrameOutside", frame, last));
      }
      return frame;
    } catch (MalformedBytes e) {
      throw at(end, e.getMessage());
    }
  }
}
