package org.pendant.controller.device;

import java.util.ArrayList;
import java.util.List;

/** Encoder lines: leads a belt of a cell to the encoders of all its controllers. */
public final class EncoderLines implements EncoderTicks {
  private final List<EncoderTicks> all = new ArrayList<>();

  /** Lines to nowhere yet. */
  public EncoderLines() {}

  /** Adds the encoders of a controller. */
  public void add(EncoderTicks encoders) {
    all.add(encoders);
  }

  @Override
  public void run(int encoder, double ticksPerS) {
    all.forEach(each -> each.run(encoder, ticksPerS));
  }
}
