package org.pendant.controller.encoder;

import org.pendant.controller.io.DigitalIo;

/** The encoders of a controller, owned by the frame loop. What is set up outlives a program. */
public final class Encoders {
  /** How many there are. */
  public static final int COUNT = 2;

  private final Encoder first = new Encoder();
  private final Encoder second = new Encoder();
  private Counts counts = new Counts(0, 0);

  /**
   * What both count, as 32 bits with a sign.
   *
   * @param first of encoder 0
   * @param second of encoder 1
   */
  public record Counts(int first, int second) {}

  /**
   * One of them.
   *
   * @param index 0 or 1
   * @throws IllegalArgumentException for another one
   */
  public Encoder get(int index) {
    if (index < 0 || index >= COUNT) {
      throw new IllegalArgumentException("encoder is " + index + ", must be 0 or 1");
    }
    return index == 0 ? first : second;
  }

  /** A frame goes by; after its inputs have been applied. */
  public void step(DigitalIo io) {
    first.step(io);
    second.step(io);
  }

  /** What both count now; the same object until one changes. */
  public Counts counts() {
    if (first.rawCount() != counts.first() || second.rawCount() != counts.second()) {
      counts = new Counts(first.rawCount(), second.rawCount());
    }
    return counts;
  }
}
