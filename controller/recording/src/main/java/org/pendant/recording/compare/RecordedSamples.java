package org.pendant.recording.compare;

import org.pendant.recording.Recording;

/** Recorded samples: a recording of Pendant's own as samples, one a frame. */
public final class RecordedSamples {
  private RecordedSamples() {}

  /** Everything in it that is worth comparing. */
  public static Samples of(Recording recording) {
    Samples.Builder builder = new Samples.Builder(SampledQuantity.all());
    for (long frame = recording.firstFrame(); frame <= recording.lastFrame(); frame++) {
      builder.add(recording.atFrame(frame));
    }
    return builder.build();
  }
}
