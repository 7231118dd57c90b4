package org.pendant.recording;

import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.DebugState;

/**
 * Moment of a recording: the end of a frame, or a stop of a debugger within it. A frame that a
 * debugger pauses several times has several moments; its end is the last of them.
 *
 * @param frame number of the frame
 * @param stop number of the debugger's stop, from 1; 0 for the end of the frame
 */
public record Moment(long frame, long stop) implements Comparable<Moment> {

  /** The end of a frame, or where a debugger still pauses it. */
  public static Moment endOf(long frame) {
    return new Moment(frame, 0);
  }

  /** When a snapshot was. */
  public static Moment of(ControllerState state) {
    return of(state.frame(), state.debug());
  }

  static Moment of(long frame, DebugState debug) {
    return new Moment(frame, debug.stop().map(DebugState.Stop::number).orElse(0L));
  }

  @Override
  public int compareTo(Moment other) {
    return frame == other.frame
        ? Long.compareUnsigned(stop - 1, other.stop - 1)
        : Long.compare(frame, other.frame);
  }
}
