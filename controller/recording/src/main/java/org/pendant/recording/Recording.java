package org.pendant.recording;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.time.FrameTime;
import org.pendant.script.debug.DebugState;
import org.pendant.script.variables.TracedVariables;

/**
 * Recording: a stretch of what one controller did: of its {@link RecordingRing} at one moment, or
 * of a file. Immutable; any thread.
 *
 * <p>Times are robot time, s since the controller was switched on; a time between two frames means
 * the frame before it, one outside of the stretch its first or last frame. From memory {@link #at}
 * is cheap enough for each movement of a mouse. A recording of a file reads the file again where it
 * is asked; all methods then throw {@link UncheckedIOException} when that has gone.
 */
public final class Recording {
  /** Once in so many frames it has where the objects of a scene are that have a mass. */
  public static final int BODIES_FRAMES = SnapshotPart.MOVED_FRAMES;

  /** Part of a frame that counts as rounding in a time. */
  private static final double ROUNDING = 1e-6;

  private final List<? extends SegmentRef> stretches;
  private final int lastCount;
  private final long lastFrame;
  private final ProgramTexts texts;
  private final Snapshots snapshots;
  private final boolean received;
  private final StretchIndex index;

  /** What was found when marks were asked for; empty before, or if there are none. */
  private volatile List<RecordingMark> marks = List.of();

  /**
   * A recording.
   *
   * @param stretches at least one, in the order of time
   * @param lastCount how many entries of the last one belong to it
   * @param lastFrame the last frame, whether it changed something or not
   * @param received whether it is of a controller that was listened to, see {@link #received}
   */
  Recording(
      List<? extends SegmentRef> stretches,
      int lastCount,
      long lastFrame,
      ProgramTexts texts,
      Snapshots snapshots,
      boolean received) {
    this.stretches = stretches;
    this.lastCount = lastCount;
    this.texts = texts;
    this.snapshots = snapshots;
    this.received = received;
    index = new StretchIndex(stretches.size());
    this.lastFrame = Math.max(lastFrame, stretches.getLast().firstFrame());
  }

  /** The arm that moves in it. */
  public ArmDescription arm() {
    return snapshots.arm();
  }

  /**
   * Whether it is of a controller that was listened to, see {@link ReceivedRecording}, rather than
   * of one of Pendant's own: what it does not tell is NaN, or nothing.
   */
  public boolean received() {
    return received;
  }

  /**
   * The columns that a controller which was listened to has sent, by their names; empty for a
   * recording of a controller of Pendant's own.
   */
  public List<String> receivedColumns() {
    return received ? atFrame(firstFrame()).traced().names() : List.of();
  }

  /**
   * Shows the rows of {@link #receivedColumns}, oldest first, each once.
   *
   * @param row gets the numbers of a row, in the order of the columns
   */
  public void receivedRows(Consumer<TracedVariables> row) {
    if (!received) {
      return;
    }
    long[] shown = {firstFrame() - 1};
    look(
        firstFrame(),
        lastFrame(),
        entry -> {
          if (entry.frame() > shown[0] && entry.changed(SnapshotPart.TRACED)) {
            shown[0] = entry.frame();
            row.accept((TracedVariables) entry.part(SnapshotPart.TRACED));
          }
        });
  }

  /** Number of its first frame. */
  public long firstFrame() {
    return stretches.getFirst().firstFrame();
  }

  /** Number of its last frame. */
  public long lastFrame() {
    return lastFrame;
  }

  /** How many frames it has. */
  public long frames() {
    return lastFrame() - firstFrame() + 1;
  }

  /** Time of its first frame, s. */
  public double firstS() {
    return timeS(firstFrame());
  }

  /** Time of its last frame, s. */
  public double lastS() {
    return timeS(lastFrame());
  }

  static double timeS(long frame) {
    return frame / (double) FrameTime.FRAMES_PER_SECOND;
  }

  /** The frame that {@link #at(double)} shows. */
  public long frameAt(double timeS) {
    double frame = Math.floor(timeS * FrameTime.FRAMES_PER_SECOND + ROUNDING);
    return inside((long) frame);
  }

  private long inside(long frame) {
    return Math.clamp(frame, firstFrame(), lastFrame());
  }

  /** What the controller published at a time. */
  public ControllerState at(double timeS) {
    return atFrame(frameAt(timeS));
  }

  /**
   * What the controller published in a frame: the last of it, where a debugger paused the frame or
   * commands came into force after it while robot time stood.
   */
  public ControllerState atFrame(long frame) {
    long wanted = inside(frame);
    int index = stretchOf(wanted);
    Segment segment = stretches.get(index).segment();
    int count = count(index, segment);
    SegmentCursor cursor = new SegmentCursor(segment, count);
    return snapshots.of(cursor.to(segment.entryAt(wanted, count)), wanted);
  }

  /** Whether {@link #at(Moment)} needs nothing of a file. */
  public boolean inMemory(Moment moment) {
    long frame = inside(moment.frame());
    return stretches.get(stretchOf(frame)).inMemory()
        && (moment.stop() == 0 || stretches.get(stretchOf(inside(frame - 1))).inMemory());
  }

  /**
   * What the controller published at a moment; the end of its frame where the recording does not
   * have that stop of the debugger.
   */
  public ControllerState at(Moment moment) {
    long frame = inside(moment.frame());
    if (moment.stop() == 0 || frame != moment.frame()) {
      return atFrame(frame);
    }
    List<ControllerState> found = new ArrayList<>();
    look(
        frame - 1,
        frame,
        entry -> {
          DebugState debug = (DebugState) entry.part(SnapshotPart.DEBUG);
          if (entry.frame() == frame && Moment.of(frame, debug).equals(moment)) {
            found.clear();
            found.add(snapshots.of(entry, frame));
          }
        });
    return found.isEmpty() ? atFrame(frame) : found.getFirst();
  }

  /**
   * Goes through all of it, which takes as long as {@link #scan}, so that a {@link StepSearch} need
   * not do so. It is worth it for a recording of a file; one from memory is searched at once.
   */
  public void makeIndex() {
    index.make(this);
  }

  StretchIndex index() {
    return index;
  }

  /** How many stretches there are. */
  int stretches() {
    return stretches.size();
  }

  /** Before the first entry of stretch {@code index}. */
  SegmentCursor entries(int index) {
    Segment segment = stretches.get(index).segment();
    return new SegmentCursor(segment, count(index, segment));
  }

  /** The last entry of stretch {@code index}. */
  SegmentCursor lastEntry(int index) {
    Segment segment = stretches.get(index).segment();
    int count = count(index, segment);
    return new SegmentCursor(segment, count).to(count - 1);
  }

  /** The stretch that a frame of this recording is in. */
  int stretchOf(long frame) {
    int low = 0;
    int high = stretches.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (stretches.get(middle).firstFrame() <= frame) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  /**
   * What is before the newest entry of a frame, for {@link RecordingRing#continuing}: that entry is
   * made once more. The last segment may be a copy.
   */
  List<Segment> segmentsUntil(long frame) {
    List<Segment> until = new ArrayList<>();
    if (frame < firstFrame()) {
      return until;
    }
    int last = stretchOf(Math.min(frame, lastFrame));
    for (int i = 0; i < last; i++) {
      until.add(stretches.get(i).segment());
    }
    Segment segment = stretches.get(last).segment();
    int entry = segment.entryAt(frame, count(last, segment));
    int kept = segment.frame(entry) == frame ? entry : entry + 1;
    if (kept > 0) {
      until.add(segment.first(kept));
    }
    return until;
  }

  private int count(int index, Segment segment) {
    return index == stretches.size() - 1 ? lastCount : segment.published();
  }

  /** Looks at entries. */
  interface Visitor {
    /** The next entry. */
    void visit(SegmentCursor entry) throws IOException;
  }

  /**
   * Shows the entries from the one that holds in frame {@code from} to the last of frame {@code
   * to}; those at the beginning of a segment, which are whole, included.
   */
  void visit(long from, long to, Visitor visitor) throws IOException {
    long last = inside(to);
    for (int i = stretchOf(inside(from)); i < stretches.size(); i++) {
      if (stretches.get(i).firstFrame() > last) {
        return;
      }
      Segment segment = stretches.get(i).segment();
      int count = count(i, segment);
      int first = segment.entryAt(inside(from), count);
      SegmentCursor cursor = new SegmentCursor(segment, count).to(first);
      do {
        if (cursor.frame() > last) {
          return;
        }
        visitor.visit(cursor);
      } while (cursor.next());
    }
  }

  /** As {@link #visit}, for visitors that do no input and output. */
  void look(long from, long to, Visitor visitor) {
    try {
      visit(from, to, visitor);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Shows what the controller published in the frames from {@code from} to {@code to}, without
   * those in which nothing changed. Goes through all of them, so it is not for the dispatch thread.
   */
  public void frames(long from, long to, Consumer<ControllerState> reader) {
    long first = inside(from);
    // a frame that a debugger held has several entries: a look begins with the last one of a frame
    look(
        first - 1,
        to,
        entry -> {
          if (entry.frame() >= first) {
            reader.accept(snapshots.of(entry, entry.frame()));
          }
        });
  }

  /**
   * Shows what the controller published in every {@code each}th frame: those from {@code from} to
   * {@code to} whose number {@code each} divides, whether they changed something or not. Takes
   * about a microsecond for each, and as long as {@link #frames} for those between.
   */
  public void everyNth(int each, long from, long to, Consumer<ControllerState> reader) {
    long last = Math.min(to, lastFrame);
    long frame = Math.ceilDiv(Math.max(from, firstFrame()), each) * each;
    for (int i = stretchOf(frame); frame <= last; i++) {
      long end = i + 1 < stretches.size() ? stretches.get(i + 1).firstFrame() - 1 : last;
      SegmentCursor cursor = entries(i);
      for (; frame <= Math.min(end, last); frame += each) {
        reader.accept(snapshots.of(cursor.toFrame(frame), frame));
      }
    }
  }

  Snapshots snapshots() {
    return snapshots;
  }

  ProgramTexts texts() {
    return texts;
  }

  /** Log lines of the frames from {@code fromS} to {@code toS}, oldest first. */
  public List<LogEntry> log(double fromS, double toS) {
    long from = frameAt(fromS);
    List<LogEntry> entries = new ArrayList<>();
    look(
        from,
        frameAt(toS),
        entry -> {
          if (entry.frame() >= from && entry.changed(SnapshotPart.NEWS)) {
            entries.addAll(((FrameDelta) entry.part(SnapshotPart.NEWS)).entries());
          }
        });
    return entries;
  }

  /** The texts of the programs that ran, in the order of their starts. */
  public List<RecordedProgram> programs() {
    return texts.all();
  }

  /** The text of the program that ran at a time, or ran last; empty before the first. */
  public Optional<RecordedProgram> programAt(double timeS) {
    return programOf(frameAt(timeS));
  }

  /** As {@link #programAt}, for a frame. */
  public Optional<RecordedProgram> programOf(long frame) {
    return texts.all().reversed().stream().filter(each -> each.frame() <= frame).findFirst();
  }

  /**
   * Starts and ends of programs, labels, stops: what a timeline marks, in the order of time. The
   * first call goes through all of the recording, which takes as long as {@link #scan}; later ones
   * answer the same list. There are 10,000 marks at most, the newest.
   */
  public List<RecordingMark> marks() {
    List<RecordingMark> known = marks;
    if (known.isEmpty()) {
      known = new MarkSearch(this).marks();
      marks = known;
    }
    return known;
  }

  /**
   * How a number went, for drawing. Goes through all changes between both times: quick in memory,
   * but a file is read again for it, so it is not for the dispatch thread then.
   *
   * @param column which number
   * @param fromS begin of the first bucket, s
   * @param toS end of the last one, s
   * @param buckets how many equal stretches of time, such as one a pixel, at least 1
   */
  public ColumnTrace scan(Column column, double fromS, double toS, int buckets) {
    return ColumnScan.of(this, column, fromS, toS, buckets);
  }
}
