package org.pendant.desktop.scene;

import java.util.Optional;
import java.util.function.Function;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Recording;
import org.pendant.recording.lines.FrameMargins;

/**
 * Recorded trace: where the arm was in a stretch of a recording, which may be read on as that
 * grows. Belongs to one thread at a time.
 */
final class RecordedTrace {
  private final int capacity;
  private final Function<ControllerState, SafetyConfiguration> safety;
  private final ArmTrace trace;
  private Optional<Near> margins = Optional.empty();
  private long first;
  private long next;

  /** What says how near an arm is to its limits, as long as both are the same. */
  private record Near(
      ForwardKinematics kinematics, SafetyChecksum checksum, FrameMargins margins) {}

  /**
   * Nothing yet.
   *
   * @param capacity points that are remembered
   * @param first the frame from which on it is to be read
   * @param safety limits and planes that hold in a frame
   */
  RecordedTrace(int capacity, long first, Function<ControllerState, SafetyConfiguration> safety) {
    this.capacity = capacity;
    this.safety = safety;
    trace = new ArmTrace(capacity);
    this.first = first;
    next = first;
  }

  /** The first frame that has not been read. */
  long next() {
    return next;
  }

  /** What is remembered of the frames that have been read. */
  ArmTrace trace() {
    return trace;
  }

  /**
   * Reads on to a frame of a recording.
   *
   * @throws java.io.UncheckedIOException if the recording cannot be read any more; those frames are
   *     left out
   */
  void readTo(Recording recording, long frame) {
    if (next < recording.firstFrame()) {
      trace.interrupt();
      next = recording.firstFrame();
    }
    if (frame < next) {
      return;
    }
    long from = next;
    next = frame + 1;
    recording.frames(from, frame, this::add);
  }

  /**
   * Reads on to a moment and beyond it: until half of what is remembered is after it.
   *
   * @param frame of the moment
   * @param last where the stretch ends at the latest
   */
  void readAround(Recording recording, long frame, long last) {
    readTo(recording, frame);
    long before = trace.count();
    while (next <= last && trace.count() - before < capacity / 2) {
      readTo(recording, Math.min(last, next + FrameTime.FRAMES_PER_SECOND));
    }
  }

  private void add(ControllerState state) {
    trace.add(state, margins(state));
  }

  private FrameMargins margins(ControllerState state) {
    if (margins.isEmpty()
        || margins.get().kinematics() != state.arm().kinematics()
        || !margins.get().checksum().equals(state.safety().checksum())) {
      margins =
          Optional.of(
              new Near(
                  state.arm().kinematics(),
                  state.safety().checksum(),
                  new FrameMargins(state.arm(), safety.apply(state))));
    }
    FrameMargins now = margins.get().margins();
    now.look(state);
    return now;
  }

  /** Forgets what was read; it goes on from there. */
  void clear() {
    trace.clear();
    first = next;
  }

  /** The first frame that it still tells of. */
  long oldest() {
    return trace.whole()
        ? first
        : Math.max(first, Math.round(trace.trace(false).timeS(0) * FrameTime.FRAMES_PER_SECOND));
  }
}
