package org.pendant.controller.device;

/** Encoder ticks: how a belt turns the encoders of a controller. */
@FunctionalInterface
public interface EncoderTicks {
  /**
   * From now on an encoder turns so.
   *
   * @param encoder 0 or 1
   * @param ticksPerS 0 for one that stands
   */
  void run(int encoder, double ticksPerS);
}
