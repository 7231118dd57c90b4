package org.pendant.controller.encoder;

import java.util.Optional;
import org.pendant.controller.io.DigitalIo;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.offset.BeltPosition;
import org.pendant.script.value.Value;

/**
 * Encoder: one of the two of a controller (manual 15.3 to 15.7). It counts nothing until it is told
 * where its ticks come from; the count is kept when that changes.
 */
public final class Encoder implements BeltPosition {
  /** How far the filtered count goes before it wraps (manual 15.5). */
  public static final int FILTERED_SIZE = 65536;

  /** The fastest that a simulated belt may run, ticks/s. */
  public static final double MAX_TICKS_PER_S = 1_000_000;

  /** Part of a tick that counts as rounding. */
  private static final double ROUNDING = 1e-6;

  private final TickFilter filter = new TickFilter();

  /** Where ticks come from; empty for nowhere. */
  private Optional<TickSource> source = Optional.empty();

  /** All ticks, never wrapped. */
  private long total;

  private boolean levelA;
  private boolean levelB;
  private double beltTicksPerS;
  private double beltPart;

  /** A program has told a count since it was asked to. */
  private boolean told;

  /** Where ticks come from. */
  private sealed interface TickSource {
    /** The pulses of two inputs. */
    record Pulses(PulseDecoder decoder) implements TickSource {}

    /** A program tells the count, which is in a range. */
    record Told(CountRange range) implements TickSource {}

    /** A belt that is simulated, without inputs. */
    record Belt() implements TickSource {}
  }

  /** Counts the pulses of inputs from now on. */
  public void decode(PulseDecoder decoder, DigitalIo io) {
    source = Optional.of(new TickSource.Pulses(decoder));
    levelA = level(io, decoder, true);
    levelB = level(io, decoder, false);
    filter.jumpTo(total);
  }

  /** Takes the counts that a program tells from now on, which wrap at the ends of a range. */
  public void expectCounts(CountRange range) {
    source = Optional.of(new TickSource.Told(range));
    total = range.wrapped(total);
    told = false;
    filter.jumpTo(total);
  }

  /** Counts no more. */
  public void disable() {
    source = Optional.empty();
    filter.jumpTo(total);
  }

  /** Whether it knows where its ticks come from. */
  public boolean enabled() {
    return source.isPresent();
  }

  /** The range of counts that a program may tell; empty when it is not to tell any. */
  public Optional<CountRange> toldRange() {
    return source.isPresent() && source.get() instanceof TickSource.Told told
        ? Optional.of(told.range())
        : Optional.empty();
  }

  /**
   * A program tells the count: the belt has gone there the shorter way round. The first count says
   * where the belt is, not that it has moved.
   *
   * @param count in the range that the encoder expects
   * @throws IllegalStateException if it expects none
   */
  public void tell(long count) {
    CountRange range = toldRange().orElseThrow();
    total += (long) range.unwound((double) (count - range.wrapped(total)));
    if (!told) {
      told = true;
      filter.jumpTo(total);
    }
  }

  /**
   * Turns the encoder by a simulated belt, besides what its inputs do; one that is not enabled
   * becomes so. A decoder that cannot tell directions counts up whichever way the belt runs, and
   * counts that a program tells are not changed.
   *
   * @param ticksPerS 0 for a belt that stands
   * @throws IllegalArgumentException for a belt faster than {@value #MAX_TICKS_PER_S} ticks/s
   */
  public void run(double ticksPerS) {
    if (!(Math.abs(ticksPerS) <= MAX_TICKS_PER_S)) {
      throw new IllegalArgumentException(
          "encoder runs at "
              + Value.of(ticksPerS).text()
              + " ticks/s, must be -1000000 to 1000000 ticks/s");
    }
    beltTicksPerS = ticksPerS;
    if (source.isEmpty()) {
      source = Optional.of(new TickSource.Belt());
      filter.jumpTo(total);
    }
  }

  /** How fast the simulated belt runs, ticks/s. */
  public double beltTicksPerS() {
    return beltTicksPerS;
  }

  /** A frame goes by. */
  void step(DigitalIo io) {
    if (source.isEmpty()) {
      return;
    }
    switch (source.get()) {
      case TickSource.Pulses pulses -> {
        countEdges(io, pulses.decoder());
        turn(pulses.decoder().kind().bothWays() ? beltTicksPerS : Math.abs(beltTicksPerS));
      }
      case TickSource.Told told -> {}
      case TickSource.Belt belt -> turn(beltTicksPerS);
    }
    filter.step(total);
  }

  private void countEdges(DigitalIo io, PulseDecoder decoder) {
    boolean a = level(io, decoder, true);
    boolean b = level(io, decoder, false);
    total += decoder.ticks(levelA, levelB, a, b);
    levelA = a;
    levelB = b;
  }

  private static boolean level(DigitalIo io, PulseDecoder decoder, boolean first) {
    return first
        ? io.level(decoder.a().bank(), decoder.a().index())
        : io.level(decoder.b().bank(), decoder.b().index());
  }

  private void turn(double ticksPerS) {
    beltPart += ticksPerS * FrameTime.FRAME_S;
    long whole = (long) Math.floor(beltPart + ROUNDING);
    beltPart -= whole;
    total += whole;
  }

  /** The count as 32 bits with a sign. */
  public int rawCount() {
    return (int) (toldRange().isPresent() ? toldRange().get().wrapped(total) : total);
  }

  /**
   * The filtered count, from 0 to below {@value #FILTERED_SIZE}; of an encoder of fewer bits to
   * below the size of its range, where its own count wraps.
   */
  public double filteredCount() {
    double size = Math.min(FILTERED_SIZE, countedSize());
    double wrapped = filter.position() - size * Math.floor(filter.position() / size);
    return wrapped < size ? wrapped : 0;
  }

  private double countedSize() {
    return toldRange().isPresent() ? toldRange().get().size() : FILTERED_SIZE;
  }

  /** The filtered count without any wrapping, for who looks at differences. */
  @Override
  public double filteredTotal() {
    return filter.position();
  }

  /**
   * A difference of two counts without the jump of a wrap between them. Ticks of pulses wrap as the
   * filtered count does.
   *
   * @return empty if the encoder is not enabled
   */
  public Optional<Double> unwound(double difference) {
    if (source.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(toldRange().orElse(CountRange.UNSIGNED_16).unwound(difference));
  }
}
