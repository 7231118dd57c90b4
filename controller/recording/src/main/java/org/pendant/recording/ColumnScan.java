package org.pendant.recording;

import java.util.Arrays;
import org.pendant.models.time.FrameTime;

/** Column scan: follows one number through a recording. */
final class ColumnScan {
  /** How often a number that has to be worked out is looked at in each stretch of time. */
  private static final int LOOKS = 4;

  private final long from;
  private final double framesEach;
  private final double[] lowest;
  private final double[] highest;
  private final double[] last;
  private int bucket = -1;
  private double value = Double.NaN;
  private long looked = Long.MIN_VALUE;

  private ColumnScan(double fromS, double widthS, int buckets) {
    from = Math.round(fromS * FrameTime.FRAMES_PER_SECOND);
    framesEach = widthS * FrameTime.FRAMES_PER_SECOND;
    lowest = new double[buckets];
    highest = new double[buckets];
    last = new double[buckets];
    Arrays.fill(lowest, Double.NaN);
    Arrays.fill(highest, Double.NaN);
    Arrays.fill(last, Double.NaN);
  }

  static ColumnTrace of(Recording recording, Column column, double fromS, double toS, int buckets) {
    if (buckets < 1 || !(toS > fromS)) {
      throw new IllegalArgumentException(
          "scan: " + buckets + " buckets from " + fromS + " s to " + toS + " s");
    }
    double widthS = (toS - fromS) / buckets;
    ColumnScan scan = new ColumnScan(fromS, widthS, buckets);
    if (toS >= recording.firstS() && fromS <= recording.lastS()) {
      scan.follow(recording, column, recording.frameAt(fromS), recording.frameAt(toS));
    }
    return new ColumnTrace(fromS, widthS, scan.lowest, scan.highest, scan.last);
  }

  private void follow(Recording recording, Column column, long first, long end) {
    recording.look(
        first,
        end,
        entry -> {
          long frame = Math.max(first, entry.frame());
          switch (column.reading()) {
            case Column.Reading.Kept kept -> {
              if (bucket < 0 || entry.changed(kept.group())) {
                take(frame, entry.number(kept.group(), kept.index()));
              }
            }
            case Column.Reading.OfPart of -> {
              if (bucket < 0 || entry.changed(of.part())) {
                take(frame, of.of().applyAsDouble(entry.part(of.part())));
              }
            }
            case Column.Reading.OfState of -> {
              if (frame - looked >= framesEach / LOOKS || bucket < 0) {
                looked = frame;
                take(frame, of.of().applyAsDouble(recording.snapshots().of(entry, frame)));
              }
            }
          }
        });
    hold(Math.min(end, recording.lastFrame()) + 1);
  }

  /** From frame {@code frame} on the value is {@code next}. */
  private void take(long frame, double next) {
    hold(frame);
    value = next;
    bucket = Math.max(bucket, bucketOf(frame));
    include(bucket);
  }

  /** The value has held until frame {@code end}, which is not its own any more. */
  private void hold(long end) {
    if (bucket < 0) {
      return;
    }
    int lastOne = bucketOf(end - 1);
    while (bucket < lastOne) {
      bucket++;
      include(bucket);
    }
  }

  private int bucketOf(long frame) {
    return Math.clamp((long) Math.floor((frame - from) / framesEach), 0, last.length - 1);
  }

  private void include(int i) {
    if (Double.isNaN(lowest[i])) {
      lowest[i] = value;
      highest[i] = value;
    } else if (!Double.isNaN(value)) {
      lowest[i] = Math.min(lowest[i], value);
      highest[i] = Math.max(highest[i], value);
    }
    last[i] = value;
  }
}
