package org.pendant.recording.compare;

import java.util.OptionalDouble;
import org.pendant.models.time.FrameTime;

/**
 * Track tolerance: by how much two runs may differ that count as the same.
 *
 * @param deg how far each joint may be from where it was, degrees; empty for anywhere
 * @param mm how far the TCP may be from where it was; empty for anywhere
 * @param seconds by how much everything may come earlier or later
 */
public record TrackTolerance(OptionalDouble deg, OptionalDouble mm, double seconds) {
  long frames() {
    return Math.round(Math.floor(seconds / FrameTime.FRAME_S + FrameTime.ROUNDING));
  }
}
