package org.pendant.recording;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;

/**
 * Recording ring: the last stretch of robot time of one controller, within a bound of memory: the
 * oldest frames are dropped. The thread that drives the controller writes, with {@link #take} after
 * each frame; every thread may read, with {@link #recording}. No thread waits for another.
 *
 * <p>Frames are kept at 500 Hz with every bit. A frame that changed nothing takes nothing; while
 * nothing else changes, temperatures, energies and execution times are kept once a second only.
 */
public final class RecordingRing {
  /** A bound that holds four minutes of an arm that never rests, and days of one that does. */
  public static final long STANDARD_BYTES = 96L << 20;

  private final Supplier<Optional<Source>> programSource;
  private final long mostBytes;
  private final Consumer<Segment> finished;
  private final Snapshots snapshots;
  private final SnapshotEncoder snapshotEncoder;

  /** Bytes of all segments but the one that is being filled. */
  private long fullBytes;

  private volatile Segment[] segments = new Segment[0];
  private volatile ProgramTexts texts = ProgramTexts.NONE;
  private volatile long lastFrame;

  /**
   * Begins with a snapshot, such as the one before the first frame.
   *
   * @param programSource the text of the running or last program, asked in the frame in which one
   *     starts, such as {@code controller::programSource}
   */
  public RecordingRing(ControllerState start, Supplier<Optional<Source>> programSource) {
    this(start, programSource, STANDARD_BYTES);
  }

  /**
   * As {@link #RecordingRing(ControllerState, Supplier)}.
   *
   * @param store keeps most of what is recorded outside of the memory
   */
  public RecordingRing(
      ControllerState start, Supplier<Optional<Source>> programSource, NumberStore store) {
    this(start, programSource, STANDARD_BYTES, store::keep);
  }

  /**
   * As {@link #RecordingRing(ControllerState, Supplier)}.
   *
   * @param mostBytes about how much memory the ring takes; at least that of two of its segments,
   *     about a megabyte
   */
  public RecordingRing(
      ControllerState start, Supplier<Optional<Source>> programSource, long mostBytes) {
    this(start, programSource, mostBytes, segment -> {});
  }

  /**
   * As the public constructors.
   *
   * @param finished gets each segment to which nothing is appended any more, in a frame
   */
  RecordingRing(
      ControllerState start,
      Supplier<Optional<Source>> programSource,
      long mostBytes,
      Consumer<Segment> finished) {
    this.finished = finished;
    this.programSource = programSource;
    this.mostBytes = mostBytes;
    snapshots = Snapshots.like(start);
    lastFrame = start.frame();
    snapshotEncoder =
        new SnapshotEncoder(start, this::begun, this::full, SnapshotEncoder.AMBIENT_FRAMES);
  }

  /**
   * Continues with another controller that has done the same as the one of {@code before}, from a
   * frame of that on: what was before the frame is kept.
   *
   * @param before of a ring
   * @param start where the other controller is
   */
  public static RecordingRing continuing(
      Recording before, ControllerState start, Supplier<Optional<Source>> programSource) {
    return new RecordingRing(before, start, programSource, segment -> {});
  }

  /** As {@link #continuing(Recording, ControllerState, Supplier)}, with a store. */
  public static RecordingRing continuing(
      Recording before,
      ControllerState start,
      Supplier<Optional<Source>> programSource,
      NumberStore store) {
    return new RecordingRing(before, start, programSource, store::keep);
  }

  private RecordingRing(
      Recording before,
      ControllerState start,
      Supplier<Optional<Source>> programSource,
      Consumer<Segment> finished) {
    this.finished = finished;
    this.programSource = programSource;
    mostBytes = STANDARD_BYTES;
    snapshots = Snapshots.like(start);
    lastFrame = start.frame();
    segments = before.segmentsUntil(start.frame()).toArray(Segment[]::new);
    Arrays.stream(segments).forEach(finished);
    fullBytes = Arrays.stream(segments).mapToLong(Segment::bytes).sum();
    texts = before.texts().until(start.frame());
    snapshotEncoder =
        new SnapshotEncoder(start, this::begun, this::full, SnapshotEncoder.AMBIENT_FRAMES);
  }

  /** Takes a frame that has ended. For the thread that drives the controller. */
  public void take(ControllerState state) {
    snapshotEncoder.take(state);
    lastFrame = state.frame();
    if (!state.newProgramEvents().isEmpty()) {
      RecordedProgram.startedIn(state, programSource).ifPresent(this::note);
    }
  }

  void note(RecordedProgram text) {
    texts = texts.with(text);
  }

  /**
   * What is kept now; it stays as it is while the ring continues. Any thread, at next to no cost.
   */
  public Recording recording() {
    // in this order: what is read later may be newer, and then holds more than was asked for
    long last = lastFrame;
    ProgramTexts then = texts;
    Segment[] now = segments;
    int count = now[now.length - 1].published();
    return new Recording(Arrays.asList(now), count, last, then, snapshots, false);
  }

  /** About how much memory is taken, bytes. For the thread that drives the controller. */
  long bytes() {
    return fullBytes + snapshotEncoder.segment().bytes() + texts.bytes();
  }

  private void full(Segment done) {
    Segment trimmed = done.trimmed();
    fullBytes += trimmed.bytes();
    Segment[] changed = segments.clone();
    changed[changed.length - 1] = trimmed;
    segments = changed;
    finished.accept(trimmed);
  }

  private void begun(Segment next) {
    Segment[] now = segments;
    int dropped = 0;
    long limit = mostBytes - next.bytes() - texts.bytes();
    while (dropped < now.length - 1 && fullBytes > limit) {
      fullBytes -= now[dropped].bytes();
      dropped++;
    }
    Segment[] changed = Arrays.copyOfRange(now, dropped, now.length + 1);
    changed[changed.length - 1] = next;
    segments = changed;
    if (dropped > 0) {
      texts = texts.from(changed[0].firstFrame());
    }
  }
}
