package org.pendant.recording.whatif;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.models.arm.Joints;

/** Joint track: where the joints of an arm were from a frame on, every few frames. Immutable. */
public final class JointTrack {
  /** No track at all. */
  public static final JointTrack NONE = new JointTrack(0, 1, new float[0]);

  private final long firstFrame;
  private final int step;
  private final float[] numbers;

  private JointTrack(long firstFrame, int step, float[] numbers) {
    this.firstFrame = firstFrame;
    this.step = step;
    this.numbers = numbers;
  }

  /**
   * Where the joints were at the end of a frame, rad, to about a hundredth of a degree; empty
   * before the track begins. After its end the arm stays where it was last.
   */
  public Optional<Joints> at(long frame) {
    int count = numbers.length / Joints.COUNT;
    if (count == 0 || frame < firstFrame) {
      return Optional.empty();
    }
    double place = Math.min((double) (frame - firstFrame) / step, count - 1.0);
    int before = (int) place;
    int after = Math.min(before + 1, count - 1);
    double[] positionRad = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      double from = numbers[before * Joints.COUNT + i];
      double to = numbers[after * Joints.COUNT + i];
      positionRad[i] = from + (place - before) * (to - from);
    }
    return Optional.of(Joints.of(positionRad));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof JointTrack track
        && firstFrame == track.firstFrame
        && step == track.step
        && Arrays.equals(numbers, track.numbers);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers);
  }

  @Override
  public String toString() {
    return "track of " + numbers.length / Joints.COUNT + " positions from frame " + firstFrame;
  }

  /** Collects a track; the longer it gets, the farther apart are its positions. */
  static final class Builder {
    private static final int STEP = 5;

    private final long firstFrame;
    private final float[] numbers;
    private int count;
    private int step = STEP;

    /** At most {@code max} positions, an even number. */
    Builder(long firstFrame, int max) {
      this.firstFrame = firstFrame;
      numbers = new float[Joints.COUNT * max];
    }

    /** Adds where the joints are at the end of a frame; frames come one by one. */
    void add(long frame, Joints positionRad) {
      if (frame - firstFrame < (long) count * step) {
        return;
      }
      if (Joints.COUNT * count == numbers.length) {
        thin();
      }
      for (int i = 0; i < Joints.COUNT; i++) {
        numbers[Joints.COUNT * count + i] = (float) positionRad.get(i);
      }
      count++;
    }

    private void thin() {
      count /= 2;
      for (int i = 0; i < count; i++) {
        System.arraycopy(numbers, 2 * Joints.COUNT * i, numbers, Joints.COUNT * i, Joints.COUNT);
      }
      step *= 2;
    }

    JointTrack track() {
      return new JointTrack(firstFrame, step, Arrays.copyOf(numbers, Joints.COUNT * count));
    }
  }
}
