package org.pendant.recording;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;

/**
 * Snapshot encoder: turns snapshots into segments of a recording. One thread feeds it; it allocates
 * when a segment is full.
 */
final class SnapshotEncoder {
  /**
   * Frames after which what never rests is kept although nothing else has changed: a second. Of an
   * arm that rests that is the noise of its sensors as well.
   */
  static final int AMBIENT_FRAMES = FrameTime.FRAMES_PER_SECOND;

  private final Consumer<Segment> begun;
  private final Consumer<Segment> full;
  private final int ambientFrames;
  private final double[] last = new double[NumberGroup.NUMBERS];
  private final double[] now = new double[NumberGroup.NUMBERS];
  private final Object[] lastParts = new Object[SnapshotPart.COUNT];

  /** What the parts were before this frame, for those that it has changed. */
  private final Object[] before = new Object[SnapshotPart.COUNT];

  private long ambientFrame;
  private Segment segment;
  private boolean handedOn;

  /**
   * Begins with a snapshot.
   *
   * @param begun gets each segment when it begins, also the first, which is in this tape already
   * @param full gets each segment that the next one follows, unless it was {@link #cut}
   * @param ambientFrames frames for which what never rests does not make an entry by itself; 0 to
   *     keep it always
   */
  SnapshotEncoder(
      ControllerState start, Consumer<Segment> begun, Consumer<Segment> full, int ambientFrames) {
    this.begun = begun;
    this.full = full;
    this.ambientFrames = ambientFrames;
    NumberGroup.read(start, last);
    for (int i = 0; i < SnapshotPart.COUNT; i++) {
      lastParts[i] = SnapshotPart.of(i).in(start);
    }
    segment = new Segment(start.frame());
    keepAll(start.frame());
    newsAreOld();
    begun.accept(segment);
  }

  /** The segment that is being filled. */
  Segment segment() {
    return segment;
  }

  /**
   * Ends the segment that is being filled, which then belongs to the reader: what changes next
   * begins another one. Empty when nothing has changed since the last was ended.
   */
  Optional<Segment> cut() {
    if (handedOn) {
      return Optional.empty();
    }
    handedOn = true;
    return Optional.of(segment);
  }

  /** Takes what has changed. */
  void take(ControllerState state) {
    long frame = state.frame();
    int numberMask = newNumbers(state);
    int partMask = newParts(state);
    if (numberMask == 0 && partMask == 0) {
      return;
    }
    keepNumbers(numberMask);
    if ((numberMask & NumberGroup.AMBIENT.bit()) != 0) {
      ambientFrame = frame;
    }
    if (!handedOn && segment.fits(frame, numberMask)) {
      keep(frame, numberMask, partMask);
    } else {
      Segment done = segment;
      segment = new Segment(frame);
      keepAll(frame);
      if (!handedOn) {
        full.accept(done);
      }
      handedOn = false;
      begun.accept(segment);
    }
    if ((partMask & SnapshotPart.NEWS.bit()) != 0) {
      newsAreOld();
    }
  }

  /** The groups to be kept; what is restless by itself is not even read in most frames. */
  private int newNumbers(ControllerState state) {
    int restless = state.armRests() ? NumberGroup.NOISY : NumberGroup.AMBIENT.bit();
    int others = NumberGroup.ALL & ~restless;
    NumberGroup.read(state, now, others);
    if (state.frame() - ambientFrame < ambientFrames
        && NumberGroup.differences(now, last, others) == 0) {
      return 0;
    }
    NumberGroup.read(state, now, restless);
    return NumberGroup.differences(now, last);
  }

  private void newsAreOld() {
    int news = SnapshotPart.NEWS.index();
    lastParts[news] = ((FrameDelta) lastParts[news]).old();
  }

  private int newParts(ControllerState state) {
    int mask = 0;
    for (int i = 0; i < SnapshotPart.COUNT; i++) {
      SnapshotPart part = SnapshotPart.of(i);
      if (part == SnapshotPart.NEWS && !FrameDelta.in(state)) {
        continue;
      }
      if (part == SnapshotPart.MOVED && state.frame() % SnapshotPart.MOVED_FRAMES != 0) {
        continue;
      }
      Object value = part.in(state);
      if (!value.equals(lastParts[i])) {
        before[i] = lastParts[i];
        lastParts[i] = value;
        mask |= 1 << i;
      }
    }
    return mask;
  }

  private void keepNumbers(int mask) {
    int at = 0;
    for (int group = 0; group < NumberGroup.COUNT; group++) {
      int size = NumberGroup.sizeOf(group);
      if ((mask & 1 << group) != 0) {
        System.arraycopy(now, at, last, at, size);
      }
      at += size;
    }
  }

  private void keepAll(long frame) {
    // what the segment before has as well may outlive that: it counts here once more
    Arrays.fill(before, MemoryEstimate.NOTHING);
    keep(frame, NumberGroup.ALL, SnapshotPart.ALL);
  }

  private void keep(long frame, int numberMask, int partMask) {
    segment.begin(frame, numberMask, partMask);
    int at = 0;
    for (int group = 0; group < NumberGroup.COUNT; group++) {
      int size = NumberGroup.sizeOf(group);
      if ((numberMask & 1 << group) != 0) {
        segment.add(last, at, size);
      }
      at += size;
    }
    for (int left = partMask; left != 0; left &= left - 1) {
      int i = Integer.numberOfTrailingZeros(left);
      segment.add(lastParts[i], MemoryEstimate.of(lastParts[i], before[i]));
    }
    segment.publish();
  }
}
