package org.pendant.recording.compare;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.ReceivedRecording;

/**
 * Track recording: a run track as a recording that can be looked at: joints, which are where they
 * had to be, and digital outputs. Of everything else it has what a recording has of a controller
 * that does not tell it.
 */
public final class TrackRecording {
  private static final List<String> OTHERS =
      List.of("actual_digital_output_bits", "robot_mode", "safety_mode");
  private static final int CONFIGURABLE_BITS = 8;
  private static final int TOOL_BITS = 16;

  private TrackRecording() {}

  /**
   * Writes it as a {@code .rec} file.
   *
   * @param arm which a track does not tell
   * @param out is closed
   */
  public static void write(RunTrack track, ArmDescription arm, OutputStream out)
      throws IOException {
    List<RunTrack.Switch> switches = track.switches();
    int next = 0;
    double outputs = 0;
    try (ReceivedRecording recording = new ReceivedRecording(out, arm, columns())) {
      for (long frame = track.firstFrame(); frame <= track.lastFrame(); frame++) {
        while (next < switches.size() && switches.get(next).frame() <= frame) {
          RunTrack.Switch change = switches.get(next);
          outputs += (change.on() ? 1 : -1) * bit(change);
          next++;
        }
        recording.write(row(frame, track.target(frame), outputs));
      }
    }
  }

  private static List<String> columns() {
    List<String> columns = new ArrayList<>(List.of(ReceivedRecording.TIME));
    for (String quantity : List.of("target_q_", "actual_q_")) {
      for (int i = 0; i < Joints.COUNT; i++) {
        columns.add(quantity + i);
      }
    }
    columns.addAll(OTHERS);
    return columns;
  }

  private static double[] row(long frame, Joints targetRad, double outputs) {
    double[] row = new double[1 + 2 * Joints.COUNT + OTHERS.size()];
    row[0] = frame * FrameTime.FRAME_S;
    for (int i = 0; i < Joints.COUNT; i++) {
      row[1 + i] = targetRad.get(i);
      row[1 + Joints.COUNT + i] = targetRad.get(i);
    }
    int at = 1 + 2 * Joints.COUNT;
    row[at] = outputs;
    row[at + 1] = RobotMode.RUNNING.code();
    row[at + 2] = SafetyMode.NORMAL.code();
    return row;
  }

  private static double bit(RunTrack.Switch change) {
    SignalBank bank = change.signal().bank();
    int shift =
        switch (bank) {
          case CONFIGURABLE_OUT -> CONFIGURABLE_BITS;
          case TOOL_OUT -> TOOL_BITS;
          default -> 0;
        };
    return 1 << (shift + change.signal().index());
  }
}
