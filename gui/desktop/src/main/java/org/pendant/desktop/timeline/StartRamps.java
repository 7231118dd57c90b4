package org.pendant.desktop.timeline;

import java.util.ArrayList;
import java.util.List;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.StartRamp;
import org.pendant.recording.Column;
import org.pendant.recording.ColumnTrace;
import org.pendant.recording.Recording;

/** Start ramps: where the start of a program has made its moves slower. */
final class StartRamps {
  /** A ramp that would be narrower than so many buckets is not looked for. */
  private static final double MIN_BUCKETS = 2;

  private final Recording recording;

  private StartRamps(Recording recording) {
    this.recording = recording;
  }

  /**
   * Those of some programs that can be seen in a stretch of a recording, of a controller with start
   * ramps.
   *
   * @param buckets how finely the stretch is shown
   */
  static List<Tracks.Bar> of(
      Recording recording, List<Tracks.Run> runs, TimeRange range, int buckets) {
    List<Tracks.Bar> ramps = new ArrayList<>();
    if (StartRamp.DURATION_S * buckets < MIN_BUCKETS * range.widthS()) {
      return ramps;
    }
    StartRamps found = new StartRamps(recording);
    double overS = Double.NEGATIVE_INFINITY;
    for (Tracks.Run run : runs) {
      double toS = run.fromS() + StartRamp.DURATION_S;
      boolean seen = toS >= range.fromS() && run.fromS() <= range.toS();
      if (seen && run.fromS() > overS && found.has(run.fromS(), toS)) {
        ramps.add(new Tracks.Bar(run.fromS(), Math.min(toS, run.toS())));
        overS = toS;
      }
    }
    return ramps;
  }

  /** Whether the arm rests before a time and moves in the stretch after it. */
  private boolean has(double fromS, double toS) {
    double beforeS = fromS - FrameTime.FRAME_S;
    if (beforeS < recording.firstS()) {
      return false;
    }
    Joints before = recording.at(beforeS).arm().targetSpeedRadPerS();
    return before.equals(Joints.ZERO) && moves(fromS, toS);
  }

  private boolean moves(double fromS, double toS) {
    boolean moves = false;
    for (int joint = 0; joint < Joints.COUNT && !moves; joint++) {
      ColumnTrace speed = recording.scan(Column.of("target_qd", joint), fromS, toS, 1);
      moves = speed.highest(0) > 0 || speed.lowest(0) < 0;
    }
    return moves;
  }
}
